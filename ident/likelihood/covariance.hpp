#pragma once

#include <Eigen/Core>

namespace jointid::ident {

/// The inverse of an information matrix, worked out with unit diagonal. Directions without information get huge variances.
Eigen::MatrixXd covariance_of(const Eigen::MatrixXd& information);

}  // namespace jointid::ident
