#pragma once

#include <optional>
#include <span>

namespace jointid::oscillation {

/// Where p(t) = Σ c_k t^k first is ≤ 0 on [0, length], tangencies included; 0 if c₀ ≤ 0. Stretches are halved until bounds of p
/// show that there is none or that there is one at most, so that no root is missed, however near to the next one. At most 40
/// coefficients.
std::optional<double> first_root(std::span<const double> coefficients, double length);

}  // namespace jointid::oscillation
