#pragma once

#include <Eigen/Core>

namespace jointid::minimise {

/// The inverse of an information matrix, worked out with unit diagonal. Directions without information get huge variances.
Eigen::MatrixXd covariance_of(const Eigen::MatrixXd& information);

/// Some P with PᵀP = information.
Eigen::MatrixXd root_of(const Eigen::MatrixXd& information);

/// A basis of the directions about which the information says nothing that arithmetic could tell from zero: eigenvalues below
/// 1e-12 of the information with unit diagonal. [columns × dimension]
Eigen::MatrixXd null_space_of(const Eigen::MatrixXd& information);

/// The shortest step with information · step = gradient that leaves those directions alone, where rounding would decide.
Eigen::VectorXd determined_step(const Eigen::MatrixXd& information, const Eigen::VectorXd& gradient);

}  // namespace jointid::minimise
