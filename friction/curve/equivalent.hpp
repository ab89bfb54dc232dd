#pragma once

#include <span>
#include <vector>

#include "friction/path/element.hpp"

namespace jointid::friction {

/// What a harmonic balance sees of a joint under x = x₀ cos ωt (docs/formulas.md §10c, appendix B): the first harmonic of the force is
/// (k_e + i d_e)x₀.
struct Equivalent {
  double amplitude = 0.0;    ///< x₀
  double stiffness = 0.0;    ///< k_e (B.4)
  double damping = 0.0;      ///< d_e = E/(πx₀²) (B.5), hysteretic, same unit as the stiffness
  double energy = 0.0;       ///< E, lost in one cycle (2.10)
  double loss_factor = 0.0;  ///< d_e/k_e
};

/// amplitude > 0. Throws InputError otherwise.
Equivalent equivalent(const Element& element, double amplitude);

/// The same for several amplitudes.
std::vector<Equivalent> equivalent(const Element& element, std::span<const double> amplitudes);

/// Derivatives of k_e and d_e by the parameters of the element.
struct EquivalentDerivative {
  std::vector<double> stiffness;
  std::vector<double> damping;
};

/// By quadrature of (B.4) and (B.5) with ∂T/∂p in place of T, split at the kinks.
EquivalentDerivative equivalent_derivative(const Element& element, double amplitude);

}  // namespace jointid::friction
