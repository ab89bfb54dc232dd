#pragma once

#include "coupling/propagation.hpp"
#include "frf/set/frf_source.hpp"

namespace jointid::coupling {

/// The errors of H_asm to first order as sums of those of H, δH_asm = L δH R: propagate() without adding up. FRFs there and back of H
/// that are one measurement have one error, real and imaginary part of which are independent and may differ in size; where `variance`
/// has covariances, C = F Fᴴ, the errors of a column are F ε.
/// `twin` as in propagate(). Terms are [wanted rows, wanted columns].
frf::ErrorSums error_sums(const Sensitivity& sensitivity, const MatrixRef& h, const LineVariance& variance, const Wanted& wanted,
                          const std::vector<Index>& twin);

}  // namespace jointid::coupling
