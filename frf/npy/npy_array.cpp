#include "frf/npy/npy_array.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>

#include "frf/text/label_text.hpp"

namespace jointid::frf {
namespace {

template <class T>
T element(const char* from, bool swap) {
  std::array<char, sizeof(T)> bytes{};
  std::memcpy(bytes.data(), from, sizeof(T));
  if (swap) std::ranges::reverse(bytes);
  return std::bit_cast<T>(bytes);
}

template <class T>
Complex real_number(const char* from, bool swap) {
  return static_cast<double>(element<T>(from, swap));
}

template <class T>
Complex complex_number(const char* from, bool swap) {
  return {static_cast<double>(element<T>(from, swap)), static_cast<double>(element<T>(from + sizeof(T), swap))};
}

using ReadNumber = Complex (*)(const char*, bool);

ReadNumber number_of(char kind, std::size_t width) {
  if (kind == 'f') return width == 4 ? real_number<float> : real_number<double>;
  if (kind == 'c') return width == 8 ? complex_number<float> : complex_number<double>;
  const bool is_signed = kind == 'i';
  switch (width) {
    case 1:
      return is_signed ? real_number<std::int8_t> : real_number<std::uint8_t>;
    case 2:
      return is_signed ? real_number<std::int16_t> : real_number<std::uint16_t>;
    case 4:
      return is_signed ? real_number<std::int32_t> : real_number<std::uint32_t>;
    default:
      return is_signed ? real_number<std::int64_t> : real_number<std::uint64_t>;
  }
}

/// Characters of UTF-32 or bytes as UTF-8.
std::string text_of(const NpyHeader& header, const char* from, bool swap) {
  std::string text;
  const std::size_t step = header.kind == 'U' ? 4 : 1;
  for (std::size_t at = 0; at + step <= header.width; at += step) {
    const std::uint32_t code = step == 4 ? element<std::uint32_t>(from + at, swap) : static_cast<unsigned char>(from[at]);
    if (code == 0) break;
    if (step == 1)
      text += static_cast<char>(code);
    else
      append_utf8(text, code);
  }
  return text;
}

/// Calls visit(place in the file) for all elements, the last index fastest.
template <class Visit>
void for_each_element(const NpyHeader& header, std::size_t count, const Visit& visit) {
  if (!header.fortran_order || header.shape.size() < 2) {
    for (std::size_t i = 0; i < count; ++i) visit(i);
    return;
  }
  std::vector<std::size_t> index(header.shape.size(), 0);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t place = 0;
    for (std::size_t axis = index.size(); axis-- > 0;) place = place * header.shape[axis] + index[axis];
    visit(place);
    for (std::size_t axis = index.size(); axis-- > 0 && ++index[axis] == header.shape[axis];) index[axis] = 0;
  }
}

/// Whether numbers of this byte order are not this machine's.
bool is_foreign_order(bool big_endian) { return big_endian != (std::endian::native == std::endian::big); }

}  // namespace

std::vector<Complex> npy_numbers(const NpyField& field, std::string_view record) {
  const ReadNumber number = number_of(field.kind, field.width);
  std::vector<Complex> values(field.count);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = number(record.data() + field.offset + i * field.stride, is_foreign_order(field.big_endian));
  return values;
}

MatInfo npy_info(const NpyHeader& header, std::string name) {
  MatInfo info{.name = std::move(name), .dims = {header.shape.rbegin(), header.shape.rend()}};
  if (header.kind == 'c') info.kind = MatKind::complex;
  if (header.is_real() || header.kind == 'b') info.kind = MatKind::real;
  info.integers = header.kind == 'i' || header.kind == 'u';
  if (header.kind == 'U' || header.kind == 'S') info.kind = MatKind::text;
  return info;
}

std::size_t npy_bytes(const NpyHeader& header, const std::string& file) {
  std::uint64_t bytes = header.width;
  for (const std::uint64_t extent : header.shape) {
    if (__builtin_mul_overflow(bytes, extent, &bytes) || bytes > std::numeric_limits<std::uint64_t>::max() / 2)
      fail_npy(file, "the array has more numbers than any file", "write it again with numpy.save()");
  }
  return bytes;
}

MatVariable npy_variable(const NpyHeader& header, MatInfo info, std::string_view elements) {
  MatVariable out{.info = std::move(info), .values = {}, .texts = {}};
  const bool swap = is_foreign_order(header.big_endian), text = out.info.kind == MatKind::text;
  const std::size_t count = header.width == 0 ? 0 : elements.size() / header.width;
  const ReadNumber number = number_of(header.kind, header.width);
  text ? out.texts.reserve(count) : out.values.reserve(count);
  for_each_element(header, count, [&](std::size_t place) {
    const char* from = elements.data() + place * header.width;
    if (text)
      out.texts.push_back(text_of(header, from, swap));
    else
      out.values.push_back(number(from, swap));
  });
  return out;
}

}  // namespace jointid::frf
