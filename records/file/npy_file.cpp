#include "records/file/npy_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <fstream>

#include "frf/npy/npy_header.hpp"
#include "records/file/limits.hpp"

namespace jointid::records {
namespace {

using frf::fail_npy;
using frf::NpyHeader;

std::string read_bytes(std::ifstream& in, std::size_t count, const std::filesystem::path& path) {
  std::string bytes(count, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(count));
  if (static_cast<std::size_t>(in.gcount()) != count)
    fail_npy(path.string(), "the file ends inside of it", "copy the file again");
  return bytes;
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
    fail_npy(path.string(), "the array has " + std::to_string(header.shape.size()) + " axes",
             "save an array of channels and samples");
  }
  std::uint64_t count = 1;
  for (const std::uint64_t extent : header.shape) {
    if (extent == 0) fail_npy(path.string(), "the array is empty", "save an array of channels and samples");
    if (extent > most_numbers / count)
      fail_npy(path.string(), "the array has more than 268 million numbers", "save it in several files");
    count *= extent;
  }
  return count;
}

}  // namespace

frf::Columns read_npy(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  const std::uint64_t size = std::filesystem::file_size(path);
  const NpyHeader header =
      frf::parse_npy_header(read_bytes(in, std::min<std::size_t>(size, frf::longest_npy_header), path), path.string());
  if (!header.fields.empty())
    fail_npy(path.string(), "holds records with named fields", "save the samples as one array, [channels, samples], of float64");
  if (!header.is_real()) fail_npy(path.string(), npy_type_text(header), "save it as float64");
  const std::uint64_t count = count_of(header, path), begin = header.begin;
  if (size != begin + count * header.width) {
    fail_npy(path.string(),
             "declares " + std::to_string(count * header.width) + " bytes of numbers and the file holds " +
                 std::to_string(size - begin),
             "copy the file again");
  }
  in.clear();
  in.seekg(static_cast<std::streamoff>(begin));
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
