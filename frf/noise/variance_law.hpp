#pragma once

#include <cmath>
#include <complex>

#include "frf/noise/noise_model.hpp"
#include "frf/set/quantity.hpp"

namespace jointid::frf {

/// The variance of a measured FRF H as a law of its value: proportional·(Re²H, Im²H) + constant·|c|² of the real and the
/// imaginary part when `by_part`, else proportional·|H|² + constant·|c|² of each. |c|² = |receptance/stored|² of the line
/// (to_receptance()): the constant is that of the quantity in which the file stores H.
struct VarianceLaw {
  double proportional = 0.0;  ///< ≥ 0
  double constant = 0.0;      ///< ≥ 0, unit of the stored FRF squared
  bool by_part = false;

  std::complex<double> operator()(std::complex<double> frf, double squared_factor) const {
    const double rest = constant > 0.0 ? constant * squared_factor : 0.0;
    if (by_part) return {proportional * frf.real() * frf.real() + rest, proportional * frf.imag() * frf.imag() + rest};
    const double part = proportional * std::norm(frf) + rest;
    return {part, part};
  }
};

/// The law of a noise model without its gross errors. With p = level: uniform and gaussian p²/3 by part, circular p²/2,
/// hammer half of h1_variance(); the floor adds floor²/2·`mean_square`, the mean of |stored FRF|² over the lines of the file.
VarianceLaw variance_law(const NoiseModel& model, double mean_square);

/// |receptance/stored|² at a frequency; NaN at 0 Hz for mobility and accelerance.
double squared_factor(Quantity quantity, double frequency_hz);

}  // namespace jointid::frf
