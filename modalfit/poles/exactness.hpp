#pragma once

#include <cstddef>
#include <vector>

#include "modalfit/band/band.hpp"
#include "modalfit/poles/refine.hpp"

namespace jointid::modalfit {

/// A model that follows FRFs to this share of their moduli (rms, weighted) follows them to digits that no measurement has.
inline constexpr double nearly_exact = 1e-5;

/// Σ|H|²/σ² of some FRFs.
double weighted_square(const Band& band, const std::vector<std::size_t>& entries);

/// Rms residual over modulus, weighted, of the FRFs that poles were refined with.
double deviation(const Band& band, const std::vector<std::size_t>& entries, const RefinedPoles& refined);

/// Whether poles follow the FRFs that they were refined with to nearly_exact.
bool is_exact(const Band& band, const std::vector<std::size_t>& entries, const RefinedPoles& refined);

}  // namespace jointid::modalfit
