#pragma once

#include <Eigen/Core>
#include <vector>

#include "response/orbit/periodic_problem.hpp"
#include "response/time/exact_march.hpp"

namespace jointid::response {

struct OrbitOptions {
  int first_periods = 3;   ///< marched from rest before Newton's method begins
  int most_periods = 500;  ///< in all
  /// ‖y(T) − y(0)‖ ≤ closure·‖y‖, each kind of coordinate in parts of its largest; 10⁴ times that where Newton's method gains no
  /// more.
  double closure = 1e-14;
  MarchOptions march;
};

/// A periodic motion, found by Newton's method on the map of (x, ẋ, f) over one period with its monodromy matrix Φ through
/// saltation (response.md §2, §7). Bilinear joints have their force as state, the memory of the others goes with their motion.
/// Residual force that the motion leaves free is chosen as none: the joint's largest |q| lies on its virgin curve.
struct PeriodicOrbit {
  bool closed = false;   ///< a period leads back to its beginning; else Newton's method did not settle, or time marching ended early
  double closure = 0.0;  ///< reached
  int periods = 0;       ///< marched in all
  int newton_steps = 0;
  std::size_t events = 0;   ///< in a period
  Eigen::VectorXd x, v, f;  ///< at t = 0
  JointStates joints;       ///< at t = 0
  /// Eigenvalues of Φ by falling modulus: of (x, ẋ, f of the bilinear joints, remembered turns of the others), and 1 for each
  /// other joint whose residual force is free.
  Eigen::VectorXcd multipliers;
  bool stable = false;                    ///< no modulus above 1
  std::vector<bool> residual_force_free;  ///< by joint: any of a family of forces stays; a multiplier is exactly 1
};

/// Throws InputError for input that does not fit (check()).
PeriodicOrbit find_orbit(const PeriodicProblem& problem, const OrbitOptions& options = {});

/// A state at t = 0 near the orbit, as harmonic balance knows it.
struct OrbitStart {
  Eigen::VectorXd x, v, f;                 ///< N, N, J
  std::vector<std::vector<double>> turns;  ///< of each joint: q where it turned in the period before
};

/// The same by Newton's steps from there, without periods from rest: also orbits that attract nothing.
PeriodicOrbit find_orbit(const PeriodicProblem& problem, const OrbitStart& start, const OrbitOptions& options = {});

}  // namespace jointid::response
