#pragma once

#include <vector>

#include "response/fourier/harmonics.hpp"

namespace jointid::response {

/// q(θ) = Σ Re Q_n e^{inθ} over one period 0 ≤ θ < 2π, and its reversals.
class Motion {
 public:
  /// `amplitudes`: Q_n of each harmonic; of n = 0 the real part counts.
  Motion(Harmonics harmonics, Eigen::VectorXcd amplitudes);

  const Harmonics& harmonics() const { return harmonics_; }
  const Eigen::VectorXcd& amplitudes() const { return amplitudes_; }

  double value(double theta) const;

  struct Slopes {
    double first = 0.0, second = 0.0;  ///< dq/dθ, d²q/dθ²
  };
  Slopes slopes(double theta) const;

  /// ∂q/∂(Re Q_n, Im Q_n, …) at θ: cos nθ, −sin nθ.
  Eigen::VectorXd by_unknowns(double theta) const;

  /// θ in [start, start + span) where dq/dθ changes its sign, ascending. q̇ is looked at 16 times for each period of its highest
  /// harmonic; between two samples it is followed to its extremum, so that a pair of roots there is found as well.
  std::vector<double> reversals(double start, double span) const;

  /// θ in [from, to], between two reversals, with q(θ) = target; an end where the target lies beyond it.
  double crossing(double from, double to, double target) const;

 private:
  double reversal(double from, double to, double slope_from) const;
  double extreme_slope(double from, double to) const;

  Harmonics harmonics_;
  Eigen::VectorXcd amplitudes_;
  std::vector<Complex> value_, first_, second_;  ///< coefficients of e^{inθ}, n = 0 … largest, of q, q̇, q̈
};

/// e^{ikθ}, k = 0 … powers.size() − 1.
void fill_powers(double theta, std::vector<Complex>& powers);

}  // namespace jointid::response
