#pragma once

#include <cstddef>
#include <vector>

#include "modalfit/band/band.hpp"
#include "modalfit/band/model_kind.hpp"
#include "modalfit/band/pole.hpp"

namespace jointid::modalfit {

/// A model that follows FRFs to this share of their moduli follows them to digits that no measurement has.
inline constexpr double nearly_exact = 1e-5;

/// Noise over modulus below which FRFs may be computed ones.
inline constexpr double quiet_noise = 1e-4;

/// Rms residual over modulus: of the lines of each FRF by their weights, then of the FRFs alike.
double deviation(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const std::vector<Pole>& poles);

/// The same of σ over modulus.
double relative_noise(const Band& band, const std::vector<std::size_t>& entries);

/// Whether poles follow the FRFs to nearly_exact.
bool is_exact(const Band& band, const std::vector<std::size_t>& entries, const ModelKind& kind, const std::vector<Pole>& poles);

}  // namespace jointid::modalfit
