#pragma once

#include <complex>
#include <span>
#include <vector>

namespace jointid::modalfit {

/// Modal assurance criterion |φᴴψ|²/((φᴴφ)(ψᴴψ)) (Allemang & Brown 1982): 1 for shapes that differ by a factor, 0 for orthogonal ones;
/// NaN when one of them is zero. Both of one length.
double mac(std::span<const std::complex<double>> one, std::span<const std::complex<double>> other);

}  // namespace jointid::modalfit
