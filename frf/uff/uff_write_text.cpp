#include "frf/uff/uff_write_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

#include "frf/uff/uff_text.hpp"

namespace jointid::frf::uff {
namespace {

constexpr std::size_t real_width = 13;

std::string padded(std::string text, std::size_t width) {
  if (text.size() < width) text.insert(0, width - text.size(), ' ');
  return text;
}

std::string with_point(std::string text) {
  if (text.find('.') == std::string::npos) text.insert(std::min(text.find('e'), text.size()), 1, '.');
  return text;
}

std::string digits(double value, std::chars_format format, int precision) {
  std::array<char, 400> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision).ptr;
  return with_point(std::string(buffer.data(), end));
}

}  // namespace

std::string integer_field(std::int64_t value, std::size_t width) {
  return padded(std::to_string(value), width);
}

std::string text_field(std::string_view text, std::size_t width) {
  std::string field(text.substr(0, width));
  field.resize(width, ' ');
  return field;
}

std::string real_field(double value) {
  std::string best;
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto format : {std::chars_format::fixed, std::chars_format::scientific}) {
    for (int precision = 0; precision < static_cast<int>(real_width); ++precision) {
      const std::string text = digits(value, format, precision);
      const double error = text.size() < real_width ? std::abs(*parse_real(text) - value) : smallest;
      if (error >= smallest) continue;
      smallest = error;
      best = text;
    }
  }
  return padded(best, real_width);
}

std::string double_field(double value) {
  std::array<char, 32> buffer{};
  const int length = std::snprintf(buffer.data(), buffer.size(), "%20.12E", value);
  return std::string(buffer.data(), static_cast<std::size_t>(length));
}

WrittenAxis written_axis(std::span<const double> frequency_hz, bool binary) {
  const std::size_t count = frequency_hz.size();
  WrittenAxis axis;
  axis.frequency_hz.assign(frequency_hz.begin(), frequency_hz.end());
  const double mean =
      count > 1 ? (frequency_hz.back() - frequency_hz.front()) / static_cast<double>(count - 1) : 0.0;
  axis.first = *parse_real(real_field(frequency_hz.front()));
  axis.step = *parse_real(real_field(mean));
  for (std::size_t i = 0; i < count; ++i) {
    axis.frequency_hz[i] = axis.first + static_cast<double>(i) * axis.step;
    axis.even = axis.even && std::abs(axis.frequency_hz[i] - frequency_hz[i]) <= 1e-6 * axis.step;
  }
  if (axis.even) return axis;
  axis.first = 0.0;
  axis.step = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    axis.frequency_hz[i] = binary ? frequency_hz[i] : *parse_real(real_field(frequency_hz[i]));
  }
  return axis;
}

}  // namespace jointid::frf::uff
