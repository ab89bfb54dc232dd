#include "frf/npy/npy_header.hpp"

#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <set>

#include "base/error.hpp"

namespace jointid::frf {
namespace {

constexpr std::string_view magic = "\x93NUMPY";
constexpr const char* save_again = "write it again with numpy.save()";

/// Takes the literal of a Python dictionary apart, from left to right.
class HeaderText {
 public:
  HeaderText(std::string_view text, const std::string& file) : rest_(text), file_(file) {}

  NpyHeader parse() {
    NpyHeader header;
    std::set<std::string> seen;
    expect('{');
    while (!take('}')) {
      const std::string key = quoted();
      if (!seen.insert(key).second) fail("the key '" + key + "' is there twice");
      expect(':');
      if (key == "descr")
        type(header);
      else if (key == "fortran_order")
        header.fortran_order = boolean();
      else if (key == "shape")
        header.shape = shape();
      else
        fail("the key '" + key + "' is none of descr, fortran_order and shape");
      if (!take(',')) {
        expect('}');
        break;
      }
    }
    blanks();
    if (!rest_.empty()) fail("something follows the dictionary");
    if (seen.size() != 3) fail("not all of descr, fortran_order and shape are there");
    return header;
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const { fail_npy(file_, problem, save_again); }

  void blanks() {
    while (!rest_.empty() && (rest_.front() == ' ' || rest_.front() == '\n')) rest_.remove_prefix(1);
  }
  bool take(char c) {
    blanks();
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void expect(char c) {
    if (!take(c)) fail(std::string("there is no '") + c + "' where one belongs");
  }
  bool take_word(std::string_view word) {
    blanks();
    if (!rest_.starts_with(word)) return false;
    rest_.remove_prefix(word.size());
    return true;
  }

  std::string quoted() {
    expect('\'');
    const std::size_t end = rest_.find('\'');
    if (end == std::string_view::npos || end > 32) fail("a text has no end");
    std::string text(rest_.substr(0, end));
    rest_.remove_prefix(end + 1);
    return text;
  }

  bool boolean() {
    if (take_word("True")) return true;
    if (!take_word("False")) fail("fortran_order is neither True nor False");
    return false;
  }

  void type(NpyHeader& header) {
    blanks();
    if (rest_.starts_with('[')) {
      header.kind = 'V';
      header.width = record(header.fields, {}, 0, 0);
      return;
    }
    const NpyField plain = plain_type();
    header.kind = plain.kind, header.width = plain.width, header.big_endian = plain.big_endian;
  }

  /// The fields of a list such as [('abscissa', '<f8', (801,)), ...]; returns the bytes of a record.
  std::size_t record(std::vector<NpyField>& fields, const std::string& scope, std::size_t begin, int depth) {
    constexpr std::size_t most_fields = 256, most_bytes = std::size_t{1} << 40;
    std::size_t offset = begin;
    if (depth > 4) fail("records are in records in records");
    expect('[');
    while (!take(']')) {
      expect('(');
      const std::string name = scope + quoted();
      expect(',');
      blanks();
      const std::size_t first = fields.size();
      std::size_t size = 0;
      if (rest_.starts_with('[')) {
        size = record(fields, name + ".", offset, depth + 1) - offset;
      } else {
        NpyField field = plain_type();
        field.name = name, field.offset = offset, field.stride = size = field.width;
        fields.push_back(std::move(field));
      }
      std::size_t count = 1;
      if (take(',') && !next_is(')')) {
        for (const std::uint64_t extent : shape()) {
          if (extent > most_bytes || (extent > 0 && count > most_bytes / extent)) fail("a field has more numbers than any file");
          count *= static_cast<std::size_t>(extent);
        }
        take(',');
      }
      expect(')');
      for (std::size_t k = first; count != 1 && k < fields.size(); ++k) {
        if (fields[k].count != 1) fail("a field of records holds lists of lists");
        fields[k].count = count, fields[k].stride = size;
      }
      if (size > 0 && count > most_bytes / size) fail("a field has more numbers than any file");
      offset += count * size;
      if (fields.size() > most_fields || offset > most_bytes) fail("the records have too many fields");
      if (!take(',')) {
        expect(']');
        break;
      }
    }
    return offset;
  }

  bool next_is(char c) {
    blanks();
    return rest_.starts_with(c);
  }

  NpyField plain_type() {
    const std::string descr = quoted();
    const char order = descr.empty() ? ' ' : descr[0], kind = descr.size() > 1 ? descr[1] : ' ';
    std::uint64_t width = 0;
    const auto [end, error] =
        std::from_chars(descr.data() + std::min<std::size_t>(2, descr.size()), descr.data() + descr.size(), width);
    const bool whole = error == std::errc() && end == descr.data() + descr.size();
    const bool object = descr == "|O", text = whole && (kind == 'U' || kind == 'S') && width < 4096;
    const auto one_of = [&](std::initializer_list<std::uint64_t> widths) {
      return std::ranges::find(widths, width) != widths.end();
    };
    const bool number = whole && ((kind == 'f' && one_of({4, 8})) || (kind == 'c' && one_of({8, 16})) ||
                                  (kind == 'b' && width == 1) || ((kind == 'i' || kind == 'u') && one_of({1, 2, 4, 8})));
    if (!object && !text && !number) fail_npy(file_, "holds numbers of type '" + descr + "'", "save it as float64");
    const bool bytes = object || kind == 'S' || width == 1;
    if (order != '<' && order != '>' && !(order == '|' && bytes)) fail("the byte order of '" + descr + "' is unknown");
    NpyField field;
    field.kind = kind;
    field.width = object ? 8 : static_cast<std::size_t>(kind == 'U' ? 4 * width : width);
    field.big_endian = order == '>';
    return field;
  }

  std::vector<std::uint64_t> shape() {
    std::vector<std::uint64_t> out;
    expect('(');
    while (!take(')')) {
      blanks();
      std::uint64_t extent = 0;
      const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), extent);
      if (error != std::errc() || out.size() == 32) fail("the shape is not a list of sizes");
      out.push_back(extent);
      rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
      if (!take(',')) {
        expect(')');
        break;
      }
    }
    return out;
  }

  std::string_view rest_;
  const std::string& file_;
};

}  // namespace

bool looks_like_npy(std::string_view first_bytes) { return first_bytes.starts_with(magic); }

NpyHeader parse_npy_header(std::string_view bytes, const std::string& file) {
  std::size_t at = 0;
  const auto take = [&](std::size_t count) {
    if (bytes.size() - at < count) fail_npy(file, "the file ends inside of it", "copy the file again");
    at += count;
    return bytes.substr(at - count, count);
  };
  const std::string_view start = take(magic.size() + 2);
  if (!looks_like_npy(start)) fail_npy(file, "does not begin as an array of numpy", save_again);
  const int major = start[magic.size()], minor = start[magic.size() + 1];
  if (major < 1 || major > 3 || minor != 0) {
    fail_npy(file, "format " + std::to_string(major) + "." + std::to_string(minor) + " is unknown", "write it with numpy.save()");
  }
  const std::string_view size = take(major == 1 ? 2 : 4);
  std::size_t length = 0;
  for (std::size_t i = size.size(); i-- > 0;) length = 256 * length + static_cast<unsigned char>(size[i]);
  if (length > longest_npy_header - 12)
    fail_npy(file, "it claims to have " + std::to_string(length) + " bytes", "write it with numpy.save()");
  NpyHeader header = HeaderText(take(length), file).parse();
  header.begin = at;
  return header;
}

void fail_npy(const std::string& file, std::string problem, std::string remedy) {
  throw InputError({ErrorKind::data, file, "npy header", std::move(problem), std::move(remedy)});
}

std::string npy_type_text(const NpyHeader& header) {
  const bool bytes = header.kind == 'O' || header.kind == 'S' || header.width == 1;
  const std::string order = bytes ? "|" : header.big_endian ? ">" : "<";
  const std::size_t width = header.kind == 'U' ? header.width / 4 : header.width;
  return "holds numbers of type '" + order + header.kind + (header.kind == 'O' ? std::string() : std::to_string(width)) + "'";
}

}  // namespace jointid::frf
