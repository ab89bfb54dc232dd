#include "frf/mat_module/mat_v5_matrix.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace jointid::frf::mat {
namespace {

constexpr int most_depth = 64;
constexpr std::uint64_t most_rank = 32;

enum ArrayClass : std::uint32_t {
  cell = 1,
  structure = 2,
  object = 3,
  text = 4,
  sparse = 5,
  first_number = 6,
  last_number = 15,
  opaque = 17
};

std::uint32_t integer(const unsigned char* bytes, bool big_endian) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = 256 * value + bytes[big_endian ? i : 3 - i];
  return value;
}

/// Bytes of one number of a type; 0 for types that hold none.
std::uint64_t width_of(std::uint32_t type) {
  constexpr std::array<std::uint64_t, 19> widths = {0, 1, 1, 2, 2, 4, 4, 4, 0, 8, 0, 0, 8, 8, 0, 0, 1, 2, 4};
  return type < widths.size() ? widths[type] : 0;
}

/// UTF-8, UTF-16, UTF-32: a character may take several.
bool is_unicode(std::uint32_t type) { return type >= 16 && type <= 18; }

std::uint64_t saturating_product(std::uint64_t a, std::uint64_t b) {
  std::uint64_t product = 0;
  return __builtin_mul_overflow(a, b, &product) ? std::numeric_limits<std::uint64_t>::max() : product;
}

/// One array; the arrays inside of it are walked by others like it.
class Matrix {
 public:
  Matrix(Bytes& bytes, bool big_endian, std::uint64_t size, Nested& nested, int depth)
      : bytes_(bytes), big_endian_(big_endian), left_(size), nested_(nested), depth_(depth) {}

  std::string walk(Extent extent) {
    read_flags();
    if (class_ == opaque) {
      rest();
      return {};
    }
    read_dims();
    const std::vector<unsigned char> name = payload(tag(mi_int8));
    if (class_ == cell) inner(count_);
    else if (class_ == structure) fields();
    else if (class_ == text || (class_ >= first_number && class_ <= last_number)) values(extent);
    else rest();
    if (extent == Extent::whole || depth_ > 0) pass(left_);
    return {name.begin(), name.end()};
  }

 private:
  void take(std::uint64_t count) {
    if (count > left_) throw Damaged("a size goes beyond what holds it");
    left_ -= count;
  }
  void pass(std::uint64_t count) {
    take(count);
    bytes_.skip(count);
  }

  Tag tag() {
    std::array<unsigned char, 8> raw{};
    take(raw.size());
    bytes_.read(raw);
    const Tag tag = Tag::parse(raw, big_endian_);
    std::copy_n(raw.begin() + 4, 4, small_.begin());
    return tag;
  }
  Tag tag(std::uint32_t type) {
    const Tag found = tag();
    if (found.type != type) throw Damaged("an element has type " + std::to_string(found.type) + " instead of " + std::to_string(type));
    return found;
  }

  /// Elements are padded to multiples of eight bytes.
  void padding(std::uint64_t bytes) { pass(std::min(left_, (8 - bytes % 8) % 8)); }

  void pass_payload(const Tag& tag) {
    if (tag.small) return;
    pass(tag.bytes);
    padding(tag.bytes);
  }

  /// Of a name or of dimensions: never long.
  std::vector<unsigned char> payload(const Tag& tag) {
    if (tag.small) return {small_.begin(), small_.begin() + tag.bytes};
    if (tag.bytes > 4096) throw Damaged("a name has " + std::to_string(tag.bytes) + " bytes");
    std::vector<unsigned char> bytes(tag.bytes);
    take(tag.bytes);
    bytes_.read(bytes);
    padding(tag.bytes);
    return bytes;
  }

  void read_flags() {
    const Tag found = tag(mi_uint32);
    if (found.small || found.bytes != 8) throw Damaged("its flags have another size than 8 bytes");
    const std::uint32_t flags = integer(payload(found).data(), big_endian_);
    class_ = flags & 0xff;
    complex_ = (flags & 0x0800) != 0;
    if (class_ < cell || class_ > opaque) throw Damaged("class " + std::to_string(class_) + " is unknown");
  }

  void read_dims() {
    const Tag found = tag(mi_int32);
    const std::uint64_t rank = found.bytes / 4;
    if (found.small || found.bytes % 4 != 0 || rank < 2 || rank > most_rank)
      throw Damaged("its dimensions take " + std::to_string(found.bytes) + " bytes");
    const std::vector<unsigned char> dims = payload(found);
    for (std::size_t i = 0; i < rank; ++i) {
      const std::uint32_t extent = integer(dims.data() + 4 * i, big_endian_);
      if (extent > std::numeric_limits<std::int32_t>::max()) throw Damaged("a dimension is negative");
      count_ = saturating_product(count_, extent);
    }
  }

  void values(Extent extent) {
    const bool stop = extent == Extent::header && depth_ == 0;
    for (int part = 0; part < (complex_ ? 2 : 1); ++part) {
      if (count_ == 0 && left_ == 0) return;
      const Tag found = tag();
      const std::uint64_t width = width_of(found.type), held = width == 0 ? 0 : found.bytes / width;
      if (width == 0 || (is_unicode(found.type) && class_ != text)) throw Damaged("its elements have type " + std::to_string(found.type));
      if (is_unicode(found.type) ? held < count_ : held != count_ || found.bytes % width != 0) {
        throw Damaged("it declares " + std::to_string(count_) + " elements and holds " + std::to_string(held));
      }
      if (stop && (found.small || found.bytes <= left_)) return;
      pass_payload(found);
    }
  }

  void fields() {
    const Tag found = tag(mi_int32);
    const std::vector<unsigned char> raw = payload(found);
    if (raw.size() != 4) throw Damaged("its field names have no length");
    const std::uint64_t length = integer(raw.data(), big_endian_);
    const Tag names = tag(mi_int8);
    if (length == 0 || names.bytes % length != 0) throw Damaged("its field names have no length");
    pass_payload(names);
    inner(saturating_product(count_, names.bytes / length));
  }

  void inner(std::uint64_t count) {
    if (count > nested_) throw Damaged("it holds " + std::to_string(count) + " arrays, more than a file of this size can");
    if (depth_ == most_depth) throw Damaged("its arrays are nested too deep");
    nested_ -= count;
    for (std::uint64_t i = 0; i < count; ++i) {
      const Tag found = tag(mi_matrix);
      if (found.small) throw Damaged("an array inside of it has no size");
      take(found.bytes);
      if (found.bytes > 0) Matrix(bytes_, big_endian_, found.bytes, nested_, depth_ + 1).walk(Extent::whole);
    }
  }

  /// Elements of classes that are not read; arrays among them are walked.
  void rest() {
    while (left_ > 0) {
      const Tag found = tag();
      if (found.type == mi_matrix) {
        take(found.bytes);
        if (nested_-- == 0 || depth_ == most_depth) throw Damaged("its arrays are nested too deep");
        if (found.bytes > 0) Matrix(bytes_, big_endian_, found.bytes, nested_, depth_ + 1).walk(Extent::whole);
      } else {
        if (width_of(found.type) == 0) throw Damaged("an element has type " + std::to_string(found.type));
        pass_payload(found);
      }
    }
  }

  Bytes& bytes_;
  bool big_endian_;
  std::uint64_t left_;
  Nested& nested_;
  int depth_;
  std::array<unsigned char, 4> small_{};
  std::uint32_t class_ = 0;
  bool complex_ = false;
  std::uint64_t count_ = 1;
};

}  // namespace

Tag Tag::parse(std::span<const unsigned char, 8> bytes, bool big_endian) {
  const std::uint32_t first = integer(bytes.data(), big_endian);
  if (first <= 0xffff) return {.type = first, .bytes = integer(bytes.data() + 4, big_endian)};
  const std::uint32_t count = first >> 16;
  if (count > 4) throw Damaged("a small element has " + std::to_string(count) + " bytes");
  return {.type = first & 0xffff, .bytes = count, .small = true};
}

std::string walk_matrix(Bytes& bytes, bool big_endian, std::uint64_t size, Extent extent, Nested& nested) {
  return Matrix(bytes, big_endian, size, nested, 0).walk(extent);
}

}  // namespace jointid::frf::mat
