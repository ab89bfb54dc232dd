#pragma once

#include <complex>

namespace jointid::oscillation {

/// A rubbed body and the extension that presses on it, both springs across the slider's motion (Kappagantu 6.25, 6.26). The slider
/// moves by d = A sin ωt along a plane of slope Z_m, so that its surface is at Z_e = Z_m d + Z_c. SI units.
struct NormalVibration {
  double mass = 0.0;                 ///< m_b of the body at the nub, kg, > 0
  double stiffness = 0.0;            ///< k_b of the body, N/m, > 0
  double extension_stiffness = 0.0;  ///< k_e, N/m, > 0
  double damping = 0.0;              ///< c_b, N s/m, ≥ 0
  double extension_damping = 0.0;    ///< c_e, N s/m, ≥ 0
  double slope = 0.0;                ///< Z_m, m/m
  double offset = 0.0;               ///< Z_c, m: how far the springs are pressed together

  /// √((k_b + k_e)/m_b)/2π. The first order of the normal force changes its sign near it.
  double natural_hz() const;
  /// N₀ = Z_c k_b k_e/(k_b + k_e). (6.26) counts k_e Z_c twice.
  double static_force() const;
  /// N_m = Z_m k_b k_e/(k_b + k_e), N/m: N = N₀ + N_m d while nothing vibrates.
  double static_slope() const;
};

/// Z_b = rest + Im(first e^{iωt}) and N = force + Im(force_first e^{iωt}) for d = A sin ωt.
struct NormalMotion {
  double rest = 0.0;                 ///< k_e Z_c/(k_b + k_e), m
  std::complex<double> first;        ///< (k_e + iωc_e) Z_m A/(k_b + k_e − ω²m_b + iω(c_b + c_e)), m
  double force = 0.0;                ///< N₀, N
  std::complex<double> force_first;  ///< (k_e + iωc_e)(Z_m A − first), N
};
NormalMotion normal_motion(const NormalVibration& system, double amplitude, double angular_frequency);

}  // namespace jointid::oscillation
