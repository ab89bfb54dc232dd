#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/complex.hpp"

namespace jointid::impedance {

/// Laws of a dynamic stiffness over frequency (docs/joint-line-by-line.md, Laws). s = (iωτ)^α, u = ω/(1000 rad/s).
enum class LawKind {
  hysteretic,        ///< K + iD
  kelvin_voigt,      ///< K + iωC
  zener,             ///< (K₀ + K_∞ s)/(1 + s), α = 1
  fractional_zener,  ///< the same, 0 < α ≤ 1
  linear,            ///< k₀ + k₁u + i(d₀ + d₁u): a description, not causal
  quadratic,         ///< the same with k₂u² and d₂u²
  kelvin_voigt_mass  ///< K + iωC − ω²m
};

std::string name(LawKind law);
const std::vector<std::string>& law_names();

/// A parameter and its unit where Z is in `stiffness`, "N/m".
struct LawParameter {
  std::string name, unit;
};
std::vector<LawParameter> parameters_of(LawKind law, const std::string& stiffness);

/// z(ω) and ∂z/∂θ, θ in the order of parameters_of().
struct LawValue {
  Complex z;
  Eigen::VectorXcd slope;
};
LawValue law_value(LawKind law, double omega, const Eigen::VectorXd& theta);

/// Those of `shape`, τ and α, of laws that are not linear in all parameters: 0, 1 or 2 behind the linear ones.
std::size_t shape_count(LawKind law);

}  // namespace jointid::impedance
