#pragma once

#include <complex>
#include <numbers>

namespace jointid {

using Complex = std::complex<double>;

/// ω = 2πf, rad/s.
constexpr double angular(double frequency_hz) { return 2.0 * std::numbers::pi * frequency_hz; }

/// f = ω/(2π), Hz.
constexpr double hertz(double omega) { return omega / (2.0 * std::numbers::pi); }

}  // namespace jointid
