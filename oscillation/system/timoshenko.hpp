#pragma once

#include <cstddef>
#include <vector>

namespace jointid::oscillation {

/// A clamped prismatic beam of rectangular section with a point mass at its tip. SI units.
struct ThickBeam {
  double length = 0.0, width = 0.0, thickness = 0.0;  ///< m, > 0; it bends across the thickness
  double youngs_modulus = 0.0, density = 0.0;         ///< Pa, kg/m³, > 0
  double poisson_ratio = 0.0;                         ///< ν, −1 < ν ≤ 0.5
  double tip_mass = 0.0;                              ///< kg, ≥ 0

  double bending_stiffness() const;   ///< EI, N m²
  double mass_per_length() const;     ///< ρA, kg/m
  double rotary_inertia() const;      ///< ρI, kg m
  double shear_coefficient() const;   ///< κ = 10(1 + ν)/(12 + 11ν) of a rectangle (Cowper 1966)
  double shear_stiffness() const;     ///< κGA, N, G = E/2(1 + ν)
};

/// One mode of bending, by Euler and Bernoulli and by Timoshenko.
struct ThickMode {
  double euler_hz = 0.0;    ///< 1 + cos z cosh z + μz(cos z sinh z − sin z cosh z) = 0, μ = tip mass over the beam's
  double rotary = 0.0;      ///< δω/ω to first order: −½ρI∫φ'²/(ρA∫φ² + m φ(L)²)
  double shear = 0.0;       ///< −½(EI/κGA)∫φ'''²/∫φ''²
  double timoshenko_hz = 0.0;  ///< of the transfer matrix with shear and rotary inertia, to 1e-10
};

/// The first `count` ≥ 1 modes. Throws InputError (usage) for numbers out of range.
std::vector<ThickMode> thick_modes(const ThickBeam& beam, std::size_t count);

}  // namespace jointid::oscillation
