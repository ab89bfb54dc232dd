#include "oscillation/pod/mode_comparison.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "dense/cholesky.hpp"

namespace jointid::oscillation {
namespace {

/// φᵀMφ of every column.
Eigen::VectorXd lengths(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& weighted) {
  return columns.cwiseProduct(weighted).colwise().sum().transpose().cwiseMax(0.0).cwiseSqrt();
}

Eigen::MatrixXd weighted(const Eigen::MatrixXd& columns, const Eigen::MatrixXd& mass) {
  return mass.size() == 0 ? columns : Eigen::MatrixXd(mass * columns);
}

void check_sizes(const Eigen::MatrixXd& phi, const Eigen::MatrixXd& psi, const Eigen::MatrixXd& mass) {
  if (phi.rows() != psi.rows() || (mass.size() > 0 && (mass.rows() != phi.rows() || mass.cols() != phi.rows()))) {
    throw InputError({ErrorKind::data, "", "modes",
                      "have " + std::to_string(phi.rows()) + " and " + std::to_string(psi.rows()) + " entries",
                      "give them, and the mass matrix, at the same points"});
  }
}

}  // namespace

Eigen::MatrixXd mode_cosines(const Eigen::MatrixXd& phi, const Eigen::MatrixXd& psi, const Eigen::MatrixXd& mass) {
  check_sizes(phi, psi, mass);
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

ModeContributions mode_contributions(const Eigen::MatrixXd& phi, const Eigen::MatrixXd& psi, const Eigen::MatrixXd& mass) {
  check_sizes(phi, psi, mass);
  const Eigen::VectorXd length = lengths(psi, weighted(psi, mass));
  Eigen::MatrixXd unit = psi;
  for (Eigen::Index k = 0; k < psi.cols(); ++k) unit.col(k) /= length(k) > 0.0 ? length(k) : 1.0;
  const Eigen::MatrixXd right = weighted(unit, mass), gram = unit.transpose() * right;
  const auto factor = dense::cholesky(gram);
  if (!factor || factor->diagonal().cwiseAbs().minCoeff() < 1e-7)
    throw InputError({ErrorKind::data, "", "modes", "depend on each other", "leave out those that others give"});
  const Eigen::MatrixXd v = dense::solve_positive(gram, Eigen::MatrixXd(right.transpose() * phi));
  const Eigen::MatrixXd rest = phi - unit * v;
  ModeContributions out{Eigen::MatrixXd::Zero(phi.cols(), psi.cols()), Eigen::VectorXd::Ones(phi.cols())};
  const Eigen::VectorXd all = lengths(phi, weighted(phi, mass)), left = lengths(rest, weighted(rest, mass));
  for (Eigen::Index i = 0; i < phi.cols(); ++i) {
    const double sum = v.col(i).cwiseAbs().sum();
    if (sum > 1e-12 * all(i)) out.shares.row(i) = v.col(i).cwiseAbs().transpose() / sum;
    if (all(i) > 0.0) out.outside(i) = std::min(left(i) * left(i) / (all(i) * all(i)), 1.0);
  }
  return out;
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
