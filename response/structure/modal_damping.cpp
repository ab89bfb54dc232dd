#include "response/structure/modal_damping.hpp"

#include "dense/eigen.hpp"

namespace jointid::response {

Eigen::MatrixXd modal_damping(const Eigen::MatrixXd& mass, const Eigen::MatrixXd& stiffness, double ratio) {
  const dense::SymmetricEigen modes = dense::symmetric_eigen(stiffness, mass);
  const Eigen::MatrixXd moved = mass * modes.vectors;
  const Eigen::VectorXd rates = 2.0 * ratio * modes.values.cwiseMax(0.0).cwiseSqrt();
  return moved * rates.asDiagonal() * moved.transpose();
}

}  // namespace jointid::response
