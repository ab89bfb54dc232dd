#include "dense/eigen.hpp"

#include <Eigen/Eigenvalues>

namespace jointid::dense {

using Eigen::MatrixXd;
using Eigen::Ref;

SymmetricEigen symmetric_eigen(const Ref<const MatrixXd>& a) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(a);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXd symmetric_eigenvalues(const Ref<const MatrixXd>& a) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(a, Eigen::EigenvaluesOnly).eigenvalues();
}

SymmetricEigen symmetric_eigen(const Ref<const MatrixXd>& k, const Ref<const MatrixXd>& m) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(k, m);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::VectorXcd eigenvalues(const Ref<const MatrixXd>& a) { return Eigen::EigenSolver<MatrixXd>(a, false).eigenvalues(); }

}  // namespace jointid::dense
