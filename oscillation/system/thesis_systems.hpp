#pragma once

#include <cstddef>

#include "oscillation/system/contact_system.hpp"

namespace jointid::oscillation {

/// n masses m, springs k in series from an anchor, damping cK, the last mass on a belt of speed V (3.1–3.11). K is tridiagonal
/// 2k, −k, last k (3.3). The thesis prints neither c, α, μ_S, μ_K nor N: the values here are ours (docs/oscillations.md).
struct BeltChain {
  std::size_t masses = 10;  ///< ≥ 1
  double mass = 1.0, stiffness = 1.0;
  double damping = 0.01;  ///< c, s: C = cK
  double velocity = 0.2;  ///< V
  Friction friction{0.3, 0.5, 2.0, 3.0, 0.0, std::nullopt};
};
Mechanics mechanics(const BeltChain& chain);
ContactSystem contact_system(const BeltChain& chain);

/// A clamped beam with an extension of length l at its tip whose nub rubs on a slider d = A sin ωt (6.1–6.40), by Ritz's method
/// with clamped-free modes. SI units; defaults are the thesis's.
struct Cantilever {
  double length = 0.4, width = 0.0128, thickness = 0.00086, youngs_modulus = 128e9, density = 7488.0;
  double extension = 0.076;  ///< l, m
  double extension_free = 0.064, extension_width = 0.0134, extension_thickness = 0.00056, extension_density = 6777.0;
  double fixture_mass = 0.01226;  ///< kg
  std::size_t modes = 6;          ///< ≥ 1
  double damping = 0.0;           ///< c, s: C = cK
  double amplitude = 0.0023;      ///< A, m
  double frequency_hz = 12.0;
  Friction friction{0.55, 0.748, std::nullopt, 0.345, -1.54, 20000.0};

  double bending_stiffness() const;  ///< EI, N m²
  double mass_per_length() const;    ///< ρA, kg/m
  double tip_mass() const;           ///< m_L: fixture and the free part of the extension, at the tip
};
/// q: amplitudes of the modes, contact P = φ(L) + lφ'(L).
Mechanics mechanics(const Cantilever& beam);
ContactSystem contact_system(const Cantilever& beam);

/// c of "one per cent proportional damping": 2·0.01/ω₁, ω₁ of the Ritz model.
double one_per_cent(const Cantilever& beam);
/// Natural frequencies of the Ritz model, Hz, nothing at the nub.
Eigen::VectorXd natural_frequencies(const Cantilever& beam);
/// Exact ones of the beam with the tip mass as a point: 1 + cos z cosh z + μz(cos z sinh z − sin z cosh z) = 0, μ = m_L/(ρAL).
Eigen::VectorXd tip_mass_frequencies(const Cantilever& beam);
/// Rows of y(x) and of the surface strain (h/2)y''(x) by q.
Eigen::RowVectorXd displacement_row(const Cantilever& beam, double x);
Eigen::RowVectorXd strain_row(const Cantilever& beam, double x);

}  // namespace jointid::oscillation
