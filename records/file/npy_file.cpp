#include "records/file/npy_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <limits>

#include "records/file/limits.hpp"
#include "records/file/npy_header.hpp"

namespace jointid::records {
namespace {

constexpr std::string_view magic = "\x93NUMPY";
constexpr std::size_t longest_header = 65536;

std::string read_bytes(std::ifstream& in, std::size_t count, const std::filesystem::path& path) {
  std::string bytes(count, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(count));
  if (static_cast<std::size_t>(in.gcount()) != count) fail_npy(path, "the file ends inside of it", "copy the file again");
  return bytes;
}

/// The length of the header text: two bytes in format 1.0, four in 2.0 and 3.0, little-endian.
std::size_t header_length(std::ifstream& in, const std::filesystem::path& path) {
  const std::string start = read_bytes(in, magic.size() + 2, path);
  const int major = start[magic.size()], minor = start[magic.size() + 1];
  if (major < 1 || major > 3 || minor != 0) {
    fail_npy(path, "format " + std::to_string(major) + "." + std::to_string(minor) + " is unknown", "write it with numpy.save()");
  }
  const std::string bytes = read_bytes(in, major == 1 ? 2 : 4, path);
  std::size_t length = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) length = 256 * length + static_cast<unsigned char>(bytes[i]);
  if (length > longest_header)
    fail_npy(path, "it claims to have " + std::to_string(length) + " bytes", "write it with numpy.save()");
  return length;
}

template <class T>
double number(const char* from, bool swap) {
  std::array<char, sizeof(T)> bytes{};
  std::memcpy(bytes.data(), from, sizeof(T));
  if (swap) std::ranges::reverse(bytes);
  return static_cast<double>(std::bit_cast<T>(bytes));
}

using Reader = double (*)(const char*, bool);

Reader reader_of(const NpyHeader& header) {
  if (header.kind == 'f') return header.width == 4 ? number<float> : number<double>;
  const bool is_signed = header.kind == 'i';
  switch (header.width) {
    case 1:
      return is_signed ? number<std::int8_t> : number<std::uint8_t>;
    case 2:
      return is_signed ? number<std::int16_t> : number<std::uint16_t>;
    case 4:
      return is_signed ? number<std::int32_t> : number<std::uint32_t>;
    default:
      return is_signed ? number<std::int64_t> : number<std::uint64_t>;
  }
}

/// Numbers that the shape declares; throws for other axes, none at all, and more than are read.
std::uint64_t count_of(const NpyHeader& header, const std::filesystem::path& path) {
  if (header.shape.empty() || header.shape.size() > 2) {
    fail_npy(path, "the array has " + std::to_string(header.shape.size()) + " axes", "save an array of channels and samples");
  }
  std::uint64_t count = 1;
  for (const std::uint64_t extent : header.shape) {
    if (extent == 0) fail_npy(path, "the array is empty", "save an array of channels and samples");
    if (extent > most_numbers / count) fail_npy(path, "the array has more than 268 million numbers", "save it in several files");
    count *= extent;
  }
  return count;
}

}  // namespace

bool looks_like_npy(std::string_view first_bytes) { return first_bytes.starts_with(magic); }

frf::Columns read_npy(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  const std::size_t length = header_length(in, path);
  const NpyHeader header = parse_npy_header(read_bytes(in, length, path), path);
  const std::uint64_t count = count_of(header, path), begin = static_cast<std::uint64_t>(in.tellg());
  const std::uint64_t size = std::filesystem::file_size(path);
  if (size != begin + count * header.width) {
    fail_npy(path,
             "declares " + std::to_string(count * header.width) + " bytes of numbers and the file holds " +
                 std::to_string(size - begin),
             "copy the file again");
  }
  const std::string bytes = read_bytes(in, count * header.width, path);
  const std::size_t rows = header.shape[0], columns = count / rows;
  const bool along_rows = columns >= rows;  // samples lie along the second axis
  const std::size_t channels = std::min(rows, columns), samples = std::max(rows, columns);
  const Reader read = reader_of(header);
  const bool swap = header.big_endian != (std::endian::native == std::endian::big);
  frf::Columns out{path.string(), {}};
  for (std::size_t c = 0; c < channels; ++c) {
    frf::NumberColumn column{std::to_string(c + 1), {}, std::vector<double>(samples)};
    for (std::size_t k = 0; k < samples; ++k) {
      const std::size_t row = along_rows ? c : k, place = along_rows ? k : c;
      column.values[k] =
          read(bytes.data() + header.width * (header.fortran_order ? row + place * rows : row * columns + place), swap);
    }
    out.columns.push_back(std::move(column));
  }
  return out;
}

}  // namespace jointid::records
