#include "base/random.hpp"

#include <Random123/philox.h>

#include <cmath>
#include <numbers>

namespace jointid {
namespace {

/// (k + ½)·2⁻⁵² with k the upper 52 bits: exact in double, and neither 0 nor 1 occurs.
double unit_interval(std::uint64_t bits) { return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52; }

}  // namespace

std::array<double, 4> uniform_numbers(const RandomStream& stream, std::uint64_t entry, std::uint64_t block) {
  using Generator = r123::Philox4x64;
  const Generator::key_type key = {{stream.seed, stream.trial}};
  const Generator::ctr_type counter = {{entry, block, stream.set, 0}};
  const Generator::ctr_type bits = Generator{}(counter, key);
  return {unit_interval(bits[0]), unit_interval(bits[1]), unit_interval(bits[2]), unit_interval(bits[3])};
}

std::array<double, 2> normal_numbers(const RandomStream& stream, std::uint64_t entry, std::uint64_t block) {
  const std::array<double, 4> u = uniform_numbers(stream, entry, block);
  const double radius = std::sqrt(-2.0 * std::log(u[0]));
  const double angle = 2.0 * std::numbers::pi * u[1];
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace jointid
