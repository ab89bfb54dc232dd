#pragma once

#include <span>

#include "frf/noise/variance_law.hpp"

namespace jointid::ident {

/// A squared complex error whose expectation is a·proportional + b·constant and which is Gamma distributed with the shape
/// `freedom` (complex degrees of freedom; half of the real ones).
struct SquaredError {
  double square = 0.0;
  double proportional = 0.0;  ///< sum of |H|² behind it, in the quantity of the file
  double constant = 0.0;      ///< number of errors behind it
  double freedom = 1.0;
};

/// σ² = a|H|² + b with a, b ≥ 0 from squared errors: E|e|² of an FRF. The maximum of the Gamma likelihood by weighted
/// non-negative least squares; squares beyond the 0.999 quantile are left out as gross errors, up to about half of them.
/// The law has half of it for each part; zero when there are no samples.
frf::VarianceLaw fit_noise(std::span<const SquaredError> samples);

}  // namespace jointid::ident
