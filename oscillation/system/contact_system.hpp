#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "base/eigen.hpp"

namespace jointid::oscillation {

/// M q̈ + C q̇ + K q = g + p f + e F cos ωt with one friction contact at y = pᵀq. All [n] or [n, n].
struct Mechanics {
  Eigen::MatrixXd mass, damping, stiffness;
  Eigen::VectorXd contact;   ///< p
  Eigen::VectorXd constant;  ///< g; empty: none
  Eigen::VectorXd forcing;   ///< e F; empty: none
};

/// What the contact slides on, and ω.
struct Drive {
  double velocity = 0.0;           ///< V of a belt, m/s; 0: ground
  double amplitude = 0.0;          ///< A of a slider at d = A sin ωt, m
  double angular_frequency = 0.0;  ///< ω, rad/s, of slider and forcing; ≥ 0
};

/// f = s N (μ_K + (μ_S − μ_K)e^{−α|V_r|}) while it slips with s = sgn V_r, |f| ≤ μ_S N while it sticks (Kappagantu 3.4–3.6).
struct Friction {
  double kinetic = 0.0;         ///< μ_K ≥ 0
  double statical = 0.0;        ///< μ_S ≥ μ_K
  std::optional<double> decay;  ///< α > 0, s/m; empty: Coulomb, μ_K as soon as it slips
  double normal = 1.0;          ///< N₀, N
  double normal_slope = 0.0;    ///< N_m, N/m: N = N₀ + N_m y
  std::optional<double>
      contact_stiffness;  ///< K_C > 0, N/m, of a massless spring before the slider (6.21–6.24); empty: rigid. Coulomb only
  double tilt = 0.0;      ///< θ, rad, of the contact plane against the slider's motion (4.1); N is then the load across the motion
};

/// Which way the contact moves: the drive faster than the body (force on it positive), not at all, slower.
enum class Mode { backward = -1, stick = 0, forward = 1 };
constexpr double sign(Mode mode) { return static_cast<double>(static_cast<int>(mode)); }
/// The force along the motion over the load N_Z across it, of a coefficient μ on a plane tilted by θ (Kappagantu 4.1):
/// tan(θ + atan μ) forward, tan(atan μ − θ) backward; μ without tilt. A load on the plane is N_Z/(cos θ ∓ μ sin θ).
double tilted(double coefficient, double tilt, Mode slip);

constexpr std::size_t place(Mode mode) { return static_cast<std::size_t>(static_cast<int>(mode) + 1); }

/// The same as z' = A z in each mode (beside the falling law), z = {q, q̇, 1, sin ωt, cos ωt, w}: constants and drive appended, w
/// the elongation of the contact spring while it sticks and 0 otherwise.
struct ContactSystem {
  ContactSystem(const Mechanics& mechanics, const Drive& drive, const Friction& friction);

  Eigen::Index degrees() const { return degrees_; }
  Eigen::Index size() const { return 2 * degrees_ + 4; }
  bool is_rigid() const { return !friction.contact_stiffness; }
  bool is_falling() const { return friction.decay && friction.statical > friction.kinetic; }
  /// {q, q̇} at t = 0 as a state.
  Eigen::VectorXd state(const Eigen::VectorXd& q, const Eigen::VectorXd& v) const;
  /// μ_K and μ_S along the motion, by the way the contact slips or would slip; one value without tilt.
  double kinetic(Mode slip) const { return kinetic_[place(slip)]; }
  double statical(Mode slip) const { return statical_[place(slip)]; }
  /// Whether a force can hold the contact: |f| ≤ μ_S N, by the direction of f.
  bool holds(double force, double load) const {
    return std::abs(force) <= statical(force >= 0.0 ? Mode::forward : Mode::backward) * load;
  }
  /// z' in a mode.
  Eigen::VectorXd field(Mode mode, const Eigen::VectorXd& z) const;
  /// Friction force on the body.
  double force(Mode mode, const Eigen::VectorXd& z) const;
  /// The free coordinates of a mode: q, q̇ and, sticking on a spring, w.
  std::vector<Eigen::Index> free(Mode mode) const;

  Friction friction;
  std::array<Eigen::MatrixXd, 3> drift;     ///< A by place(mode), kinetic friction contained
  std::array<Eigen::VectorXd, 3> relative;  ///< r: V_r = r·z of the slip modes
  std::array<Eigen::MatrixXd, 3> on_stick;  ///< z on entering a stick from a slip: V_r = 0 (rigid), w so that f stays (compliant)
  Eigen::MatrixXd on_slip;                  ///< z on leaving it
  Eigen::VectorXd push;                     ///< b = dz'/df
  Eigen::VectorXd normal;                   ///< ν: N = ν·z
  Eigen::VectorXd stick_force;              ///< φ: f = φ·z while it sticks

 private:
  Eigen::Index degrees_ = 0;
  std::array<double, 3> kinetic_{}, statical_{};  ///< by place(mode)
};

}  // namespace jointid::oscillation
