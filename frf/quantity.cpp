#include "frf/quantity.hpp"

#include <array>
#include <limits>
#include <numbers>

#include "frf/error.hpp"

namespace jointid::frf {
namespace {

constexpr std::array<const char*, 3> names = {"receptance", "mobility", "accelerance"};
constexpr std::array<const char*, 3> units = {"m/N", "m/(s*N)", "m/(s^2*N)"};

}  // namespace

std::string name(Quantity quantity) { return names[static_cast<std::size_t>(quantity)]; }
std::string unit(Quantity quantity) { return units[static_cast<std::size_t>(quantity)]; }

Quantity parse_quantity(std::string_view text) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (text == names[i]) return static_cast<Quantity>(i);
  }
  const std::string near = nearest_word(std::string(text), names);
  throw InputError({.kind = ErrorKind::data,
                    .file = {},
                    .place = {},
                    .problem = "unknown FRF quantity '" + std::string(text) + "'",
                    .remedy = near.empty() ? "write receptance, mobility or accelerance"
                                           : "did you mean " + near + "?"});
}

std::complex<double> from_receptance(Quantity quantity, double frequency_hz) {
  const double omega = 2.0 * std::numbers::pi * frequency_hz;
  switch (quantity) {
    case Quantity::mobility:
      return {0.0, omega};
    case Quantity::accelerance:
      return {-omega * omega, 0.0};
    case Quantity::receptance:
      break;
  }
  return {1.0, 0.0};
}

std::complex<double> to_receptance(Quantity quantity, double frequency_hz) {
  if (quantity != Quantity::receptance && frequency_hz == 0.0) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan};
  }
  return 1.0 / from_receptance(quantity, frequency_hz);
}

}  // namespace jointid::frf
