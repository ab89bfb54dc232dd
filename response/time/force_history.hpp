#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "base/eigen.hpp"

namespace jointid::response {

/// The force on a structure over time, p(t) = L g(t), N × 1, in pieces within which ġ = Λ g: sums of harmonics, and straight
/// lines. p(t) = 0 before t = 0.
class ForceHistory {
 public:
  /// p(t) = Σ_n Re P_n e^{inωt} until `until` (s), then 0; column i of `amplitudes` (N × harmonics) is P of harmonics[i] ≥ 0. p
  /// sin ωt means P₁ = −ip. Throws InputError when sizes do not fit or a number is not finite.
  static ForceHistory periodic(double omega, const std::vector<int>& harmonics, const Eigen::MatrixXcd& amplitudes,
                               double until = std::numeric_limits<double>::infinity());

  /// p(t) = `peak` sin(πt/duration) for t < duration, then 0.
  static ForceHistory half_sine(const Eigen::VectorXd& peak, double duration);

  /// Straight lines between samples: p(t) = D y(t), y = row i of `values` (samples × L) at times[i], which increase from times[0]
  /// ≥ 0; 0 before the first and after the last sample. `directions` D is N × L. Throws InputError.
  static ForceHistory sampled(const Eigen::MatrixXd& directions, const std::vector<double>& times, const Eigen::MatrixXd& values);

  Eigen::VectorXd value(double time) const { return load_ * state(time); }

  /// g(t); where a piece begins that of the piece which begins.
  Eigen::VectorXd state(double time) const;

  /// Λ
  Eigen::MatrixXd generator() const;
  /// L
  const Eigen::MatrixXd& load() const { return load_; }
  /// Begin of the next piece after `time`; +infinity when there is none.
  double next_change(double time) const;
  /// The highest frequency of the harmonics, rad/s.
  double highest_frequency() const;

 private:
  struct Piece {
    double start;
    Eigen::VectorXd state;
  };

  std::vector<double> frequencies_;  ///< (cos, sin) of each, then (value, slope) of each straight line
  Eigen::MatrixXd load_;
  std::vector<Piece> pieces_;
};

}  // namespace jointid::response
