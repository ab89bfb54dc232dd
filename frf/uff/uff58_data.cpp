#include "frf/uff/uff58_data.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "frf/uff/uff58_text.hpp"

namespace jointid::frf::uff {
namespace {

/// Takes IEEE 754 numbers of either byte order from a run of bytes.
class BinaryNumbers {
 public:
  BinaryNumbers(const std::string& bytes, bool big_endian)
      : at_(bytes.data()), swap_(big_endian != (std::endian::native == std::endian::big)) {}

  double next(std::uint64_t width) {
    return width == 4 ? static_cast<double>(take<float>()) : take<double>();
  }

 private:
  template <class T>
  T take() {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), at_, sizeof(T));
    at_ += sizeof(T);
    if (swap_) std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<T>(bytes);
  }

  const char* at_;
  bool swap_;
};

/// Sorts numbers in file order into points.
template <class Abscissa, class Ordinate>
Points gather(const Header58& header, std::uint64_t count, Abscissa abscissa, Ordinate ordinate) {
  Points points;
  points.values.resize(count);
  if (!header.even) points.abscissa.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    if (!header.even) points.abscissa[i] = abscissa();
    const double real = ordinate();
    points.values[i] = {real, header.is_complex() ? ordinate() : 0.0};
  }
  return points;
}

Points binary_points(ByteFile& file, const Dataset& dataset, std::uint64_t first, std::uint64_t count, int byte_order) {
  const Header58& header = *dataset.function;
  const std::uint64_t width = header.is_double() ? 8 : 4;
  const std::uint64_t point_bytes = (dataset.payload_end - dataset.payload_begin) / header.points;
  const std::string bytes = file.read(dataset.payload_begin + first * point_bytes, count * point_bytes);
  BinaryNumbers numbers(bytes, byte_order == 2);
  return gather(
      header, count, [&] { return numbers.next(dataset.abscissa_bytes); },
      [&] { return numbers.next(width); });
}

Points read_binary(ByteFile& file, const Dataset& dataset, std::uint64_t first, std::uint64_t count) {
  require_readable(dataset);
  return binary_points(file, dataset, first, count, dataset.byte_order);
}

/// The share of numbers that no measurement has, far beyond all powers of ten of units.
double share_of_absurd(const Points& points) {
  constexpr double least = 1e-25, most = 1e25;
  std::size_t absurd = 0;
  for (const std::complex<double>& value : points.values) {
    for (const double part : {std::abs(value.real()), std::abs(value.imag())})
      if (part != 0.0 && !(part >= least && part <= most)) ++absurd;
  }
  return static_cast<double>(absurd) / static_cast<double>(2 * points.values.size());
}

/// Throws where the first numbers make sense in the other byte order alone.
void require_byte_order(ByteFile& file, const Dataset& dataset) {
  constexpr std::uint64_t fewest = 4, enough = 64;
  if (dataset.function->points < fewest || dataset.float_format != 2) return;
  if (dataset.byte_order != 1 && dataset.byte_order != 2) return;
  const std::uint64_t count = std::min(dataset.function->points, enough);
  constexpr double many = 0.25;
  if (share_of_absurd(binary_points(file, dataset, 0, count, dataset.byte_order)) < many) return;
  const int other = 3 - dataset.byte_order;
  if (share_of_absurd(binary_points(file, dataset, 0, count, other)) > 0.0) return;
  const auto shown = [](int order) { return std::to_string(order) + (order == 1 ? " (little-endian)" : " (big-endian)"); };
  dataset.place.fail("number line",
                     "the numbers make no sense in byte order " + shown(dataset.byte_order) + ", and they do in " + shown(other),
                     "write " + std::to_string(other) + " in column 13 of the number line, or export it again");
}

Points read_text(ByteFile& file, const Dataset& dataset, std::uint64_t first, std::uint64_t count) {
  const Header58& header = *dataset.function;
  const std::vector<double> numbers = read_text_numbers(file, dataset);
  auto next = numbers.begin() + static_cast<std::ptrdiff_t>(first * header.numbers_per_point());
  const auto take = [&] { return *next++; };
  return gather(header, count, take, take);
}

}  // namespace

void require_readable(const Dataset& dataset) {
  if (!dataset.binary) return;
  constexpr const char* remedy = "export it again as IEEE binary or as ASCII";
  if (dataset.float_format == 1 || dataset.float_format == 3) {
    dataset.place.fail("number line",
                       std::string("floating-point format ") +
                           (dataset.float_format == 1 ? "1 (DEC VMS)" : "3 (IBM 5/370)") + " is not read",
                       remedy);
  }
  if (dataset.float_format != 2) {
    dataset.place.fail("number line", "unknown floating-point format " + std::to_string(dataset.float_format),
                       remedy);
  }
  if (dataset.byte_order != 1 && dataset.byte_order != 2) {
    dataset.place.fail("number line", "unknown byte order " + std::to_string(dataset.byte_order), remedy);
  }
}

Points read_points(ByteFile& file, const Dataset& dataset, std::uint64_t first, std::uint64_t count) {
  return dataset.binary ? read_binary(file, dataset, first, count) : read_text(file, dataset, first, count);
}

Points read_points(ByteFile& file, const Dataset& dataset) {
  return read_points(file, dataset, 0, dataset.function->points);
}

void require_plausible_size(ByteFile& file, const Dataset& dataset) {
  const Header58& header = *dataset.function;
  if (dataset.binary) return require_byte_order(file, dataset);
  const std::uint64_t needed = header.points * header.numbers_per_point();
  if (dataset.payload_lines * text_columns(header).size() < needed)
    read_text_numbers(file, dataset);
}

}  // namespace jointid::frf::uff
