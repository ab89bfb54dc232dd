#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "base/complex.hpp"
#include "oscillation/integrate/stick_slip.hpp"

namespace jointid::oscillation {

/// A periodic orbit, stable or not: with a multiplier beyond the unit circle no integration stays on it.
struct PeriodicOrbit {
  bool converged = false;
  double period = 0.0;               ///< s
  double residual = 0.0;             ///< largest difference of {q, q̇} after a period
  Eigen::VectorXd state;             ///< z where it begins
  Mode mode = Mode::forward;         ///< there
  std::vector<Complex> multipliers;  ///< of the return map, the largest modulus first; those of fixed directions are 0
};

/// Of a system without drive in time: by Newton on the map from a break-away to the `slips`-th after it, DP = (I − F∇hᵀ/(∇hᵀF))W.
/// `start`: near a break-away; it is moved onto V_r = 0 and |f| = μ_S N. Rigid contact only. An orbit without return within
/// `longest` s is not converged.
PeriodicOrbit break_away_orbit(const ContactSystem& system, const Eigen::VectorXd& start, std::size_t slips, double longest = 1e4,
                               const std::function<bool()>& interrupted = {});

/// Of a driven system: by Newton on the map over `cycles` periods of the drive, from a start near the orbit at phase 0 in
/// a mode.
PeriodicOrbit driven_orbit(const ContactSystem& system, const Eigen::VectorXd& start, Mode mode, double cycle, std::size_t cycles,
                           const std::function<bool()>& interrupted = {});

/// Lyapunov exponents, nats per second, with tangents across events (Benettin). The rigid stick loses a dimension: the last
/// exponent is −infinity.
struct ExponentOptions {
  std::size_t count = 1;
  double transient = 0.0, length = 0.0;  ///< s
  double interval = 0.0;                 ///< s between orthonormalisations, > 0
  std::function<bool()> interrupted = {};
};
struct Exponents {
  MotionEnd status = MotionEnd::ok;
  std::vector<double> exponent, standard_error;  ///< batch means over 20 blocks
};
Exponents lyapunov_exponents(const ContactSystem& system, const Eigen::VectorXd& start, const ExponentOptions& options);

}  // namespace jointid::oscillation
