#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "friction/fit/fitted_value.hpp"
#include "friction/path/element.hpp"
#include "minimise/least_squares.hpp"

namespace jointid::friction {

/// What a linearised least-squares problem says of its unknowns: covariance s²(JᵀJ)⁺ with s² = Σr²/(rows − unknowns), and which
/// directions of the unknowns no residual depends on (singular values of the column-scaled J below rows·ε of the largest).
class FitStatistics {
 public:
  /// At unknowns q of a problem; rows must be more than unknowns.
  FitStatistics(const minimise::LeastSquares& problem, std::span<const double> q);

  double sum_of_squares() const { return sum_; }
  double residual_std() const { return std_; }
  /// Correlation of two unknowns; NaN when one is not determined.
  double correlation(std::size_t i, std::size_t j) const;

  /// Standard error of a function of the unknowns with this gradient; nothing when it moves along what no residual sees.
  std::optional<double> std_error(const Eigen::RowVectorXd& gradient) const;

  /// The value with standard error and interval on the scale of `parameter`'s bounds, and whether the data determine it: t·s.e.
  /// less than the distance of the value from its bounds. A value that does not change with the unknowns is preset.
  FittedValue describe(const Parameter& parameter, const Eigen::RowVectorXd& gradient) const;

 private:
  double sum_ = 0.0, std_ = 0.0, quantile_ = 0.0;
  Eigen::VectorXd scale_;        ///< column norms of J, 1 for zero columns
  Eigen::MatrixXd covariance_;   ///< of the unknowns
  Eigen::MatrixXd unseen_;       ///< orthonormal directions of the scaled unknowns, columns
};

}  // namespace jointid::friction
