#include "frf/mat_module/mat_v5_check.hpp"

#include <algorithm>
#include <array>

#include "base/error.hpp"

namespace jointid::frf::mat {
namespace {

constexpr std::uint64_t header_bytes = 128, tag_bytes = 8;
/// Deflate packs at best 1032 bytes into one.
constexpr std::uint64_t best_compression = 1100;
/// Arrays inside of others that any file may have; each takes some hundred bytes of memory once matio has read it.
constexpr Nested small_file_nested = 4096;

}  // namespace

V5Check::V5Check(const std::filesystem::path& path)
    : path_(path.string()), size_(std::filesystem::file_size(path)), file_(path, std::ios::binary), nested_(small_file_nested + size_) {
  try {
    read_header();
    list();
  } catch (const Damaged& damage) {
    fail(elements_.empty() ? std::string() : "variable number " + std::to_string(elements_.size()), damage.what());
  }
}

void V5Check::read_header() {
  std::array<unsigned char, header_bytes> header{};
  stored_bytes(file_, 0, size_)->read(header);
  const unsigned char* end = header.data() + header_bytes - 4;
  big_endian_ = end[2] == 'M' && end[3] == 'I';
  const bool little = end[2] == 'I' && end[3] == 'M';
  const unsigned version = big_endian_ ? 256U * end[0] + end[1] : 256U * end[1] + end[0];
  if ((!little && !big_endian_) || version != 0x0100) throw Damaged("its header is no such of version 5");
}

void V5Check::list() {
  std::uint64_t at = header_bytes;
  while (at < size_) {
    std::array<unsigned char, tag_bytes> raw{};
    stored_bytes(file_, at, size_ - at)->read(raw);
    const Tag tag = Tag::parse(raw, big_endian_);
    elements_.push_back({.name = {}, .begin = at + tag_bytes, .bytes = tag.bytes, .packed = tag.type == mi_compressed});
    if (tag.small || (tag.type != mi_matrix && tag.type != mi_compressed))
      throw Damaged("it is no array but of type " + std::to_string(tag.type));
    if (tag.bytes > size_ - at - tag_bytes) throw Damaged("a size goes beyond the end of the file");
    elements_.back().name = walk(elements_.back(), Extent::header);
    at += tag_bytes + tag.bytes;
  }
}

std::string V5Check::walk(const Element& element, Extent extent) {
  if (!element.packed) return walk_matrix(*stored_bytes(file_, element.begin, element.bytes), big_endian_, element.bytes, extent, nested_);
  const auto bytes = inflated_bytes(file_, element.begin, element.bytes);
  std::array<unsigned char, tag_bytes> raw{};
  bytes->read(raw);
  const Tag tag = Tag::parse(raw, big_endian_);
  if (tag.small || tag.type != mi_matrix) throw Damaged("it is no array but of type " + std::to_string(tag.type));
  if (tag.bytes > best_compression * element.bytes) throw Damaged("it declares more bytes than can be packed there");
  std::string name = walk_matrix(*bytes, big_endian_, tag.bytes, extent, nested_);
  if (extent == Extent::whole) bytes->finish();
  return name;
}

std::vector<std::string> V5Check::names() const {
  std::vector<std::string> names;
  for (const Element& element : elements_) names.push_back(element.name);
  return names;
}

void V5Check::require_whole(const std::string& name) {
  const auto element = std::ranges::find(elements_, name, &Element::name);
  if (element == elements_.end()) fail("variable " + name, "is not there");
  try {
    nested_ = small_file_nested + size_;
    walk(*element, Extent::whole);
  } catch (const Damaged& damage) {
    fail("variable " + name, damage.what());
  }
}

void V5Check::fail(const std::string& place, const std::string& problem) const {
  throw InputError({.kind = ErrorKind::data,
                    .file = path_,
                    .place = place,
                    .problem = "is damaged or truncated: " + problem,
                    .remedy = "copy or export the file again"});
}

}  // namespace jointid::frf::mat
