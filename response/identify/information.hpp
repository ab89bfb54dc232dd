#pragma once

#include <Eigen/Core>
#include <optional>

namespace jointid::response {

/// What residuals in standard deviations tell of their unknowns: the covariance (JᵀJ)⁺, which is the bound of any unbiased
/// estimate, and the directions that no residual depends on (singular values of J with columns of norm 1 below 1e-9 of the
/// largest).
class Information {
 public:
  explicit Information(const Eigen::MatrixXd& jacobian);

  bool sees_all() const { return unseen_.cols() == 0; }
  /// How many directions are seen.
  Eigen::Index rank() const { return scale_.size() - unseen_.cols(); }
  /// Of the unknowns, along what is seen.
  const Eigen::MatrixXd& covariance() const { return covariance_; }
  /// Of a function of the unknowns with this gradient; nothing when it changes along what is not seen.
  std::optional<double> deviation(const Eigen::RowVectorXd& gradient) const;

 private:
  Eigen::VectorXd scale_;
  Eigen::MatrixXd covariance_, unseen_;
};

}  // namespace jointid::response
