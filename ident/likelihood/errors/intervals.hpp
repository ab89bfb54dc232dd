#pragma once

#include "ident/likelihood/errors/sensor_scatter.hpp"
#include "ident/likelihood/errors/tried_errors.hpp"

namespace jointid::ident {

/// The 95 % intervals of the joint's scaled unknowns: first those of the noise that variances tell, then what else may be in the data.
/// An interval holds all that is within the quantile of the standard deviations of each of several cases: the estimate as it is, and
/// as it would be without an error that the data leave open. Of a bias between none and all, wide beside the deviation σ, the truth can
/// lie beyond one end only: the quantile c is that of Φ(c + width/σ) − Φ(−c) = 0.95 (Imbens & Manski 2004), 1.96 to 1.64.
class Intervals {
 public:
  explicit Intervals(Eigen::MatrixXd covariance);

  /// A gain of the assembly against the parts: a case with θ + dθ/dgain · mean and the covariance + its variance · (dθ/dgain)², by the
  /// data and a prior of usual_calibration.
  void add_gain(const FileGain& gain);

  /// Errors that responses to a reference share: C becomes C + I⁻¹ S I⁻¹, somewhat more than it is, for they are a part of the
  /// variances.
  void add_shared(const SharedErrors& shared, const Eigen::MatrixXd& information);

  /// An error between none and one of these, all of which are uncertain by `scatter` (empty: they are not).
  void add_bias(const std::vector<Eigen::VectorXd>& shifts, const Eigen::MatrixXd& scatter);

  /// As large as misfit makes them: deviations `inflation` times as large, or what the jackknife says with the quantile of Student's t,
  /// whichever is wider; and the step that is left. Once more for the scatter of sensors, where that is wider.
  void include_misfit(const Jackknife& jackknife, double inflation);
  void include_sensors(const SensorScatter& sensors);

  /// Of the estimate as it is: of noise, shared errors and misfit, without what calibration costs.
  const Eigen::MatrixXd& covariance() const;
  /// Half the width of the noise's own.
  Eigen::VectorXd half_widths() const;
  /// The largest width over that of the covariance in the beginning.
  double cost() const;

  void state(const Plan& plan, Solution& out) const;

 private:
  struct Case {
    Eigen::VectorXd shift;
    Eigen::MatrixXd covariance;
  };
  /// Deviations that are at least these, with the quantile of Student's t with so many degrees of freedom where they are larger.
  void widen_to(const Eigen::VectorXd& deviation, const Eigen::VectorXd& freedom);
  std::array<double, 2> ends(Eigen::Index unknown) const;
  double quantile(Eigen::Index unknown) const;

  std::vector<Case> cases_;
  Eigen::VectorXd first_;  ///< standard deviations in the beginning
  Eigen::VectorXd width_;  ///< of all biases
  Eigen::VectorXd quantile_;
};

}  // namespace jointid::ident
