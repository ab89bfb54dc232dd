#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Fields of UFF header and data lines, right-justified in their columns.
namespace jointid::frf::uff {

std::string integer_field(std::int64_t value, std::size_t width);

/// Left-justified, cut at the width.
std::string text_field(std::string_view text, std::size_t width);

/// A 13-column field with a leading blank, in whichever of fixed and exponent notation loses least. It always
/// has a decimal point: without one a Fortran E13.5 would read five implied decimals.
std::string real_field(double value);

/// E20.12.
std::string double_field(double value);

/// An axis as a file states it.
struct WrittenAxis {
  bool even = true;
  double first = 0.0;
  double step = 0.0;
  std::vector<double> frequency_hz;  ///< as it will be read
};

/// Even when first + i·step, with both as real_field writes them, is within 1e-6 of a step of every line. The
/// abscissas of an uneven axis are exact in binary and real_field in text.
WrittenAxis written_axis(std::span<const double> frequency_hz, bool binary);

}  // namespace jointid::frf::uff
