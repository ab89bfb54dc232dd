#include "oscillation/pod/mode_comparison.hpp"

#include <algorithm>

#include "base/error.hpp"

namespace jointid::oscillation {
namespace {

/// φᵀMφ of every column.
Eigen::VectorXd lengths(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& weighted) {
  return columns.cwiseProduct(weighted).colwise().sum().transpose().cwiseMax(0.0).cwiseSqrt();
}

Eigen::MatrixXd weighted(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& mass) {
  return mass.size() == 0 ? columns : Eigen::MatrixXd(mass * columns);
}

}  // namespace

Eigen::MatrixXd mode_cosines(const Eigen::MatrixXd& phi, const Eigen::MatrixXd& psi, const Eigen::MatrixXd& mass) {
  if (phi.rows() != psi.rows() || (mass.size() > 0 && (mass.rows() != phi.rows() || mass.cols() != phi.rows()))) {
    throw InputError({ErrorKind::data, "", "modes",
                      "have " + std::to_string(phi.rows()) + " and " + std::to_string(psi.rows()) + " entries",
                      "give them, and the mass matrix, at the same points"});
  }
  const Eigen::MatrixXd right = weighted(psi, mass);
  const Eigen::VectorXd of_phi = lengths(phi, weighted(phi, mass)), of_psi = lengths(psi, right);
  Eigen::MatrixXd cosines = (phi.transpose() * right).cwiseAbs();
  for (Eigen::Index i = 0; i < cosines.rows(); ++i) {
    for (Eigen::Index j = 0; j < cosines.cols(); ++j) {
      const double both = of_phi(i) * of_psi(j);
      cosines(i, j) = both > 0.0 ? std::min(cosines(i, j) / both, 1.0) : 0.0;
    }
  }
  return cosines;
}

Eigen::MatrixXd mode_assurance(const Eigen::MatrixXd& phi, const Eigen::MatrixXd& psi) {
  return mode_cosines(phi, psi).cwiseAbs2();
}

std::vector<ModePair> matched_modes(const Eigen::MatrixXd& cosines) {
  Eigen::MatrixXd left = cosines;
  std::vector<ModePair> pairs;
  for (Eigen::Index k = 0; k < std::min(left.rows(), left.cols()); ++k) {
    Eigen::Index i = 0, j = 0;
    const double cosine = left.maxCoeff(&i, &j);
    pairs.push_back({static_cast<std::size_t>(i), static_cast<std::size_t>(j), cosine});
    left.row(i).setConstant(-1.0);
    left.col(j).setConstant(-1.0);
  }
  return pairs;
}

}  // namespace jointid::oscillation
