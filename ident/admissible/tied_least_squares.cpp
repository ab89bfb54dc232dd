#include "ident/admissible/tied_least_squares.hpp"

#include <cmath>
#include <limits>

#include "dense/pivoted_qr.hpp"
#include "minimise/linear/column_scaling.hpp"

namespace jointid::ident {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

TiedLeastSquares tied_least_squares(const MatrixXd& root, const VectorXd& theta, const VectorXd& offset, const MatrixXd& directions) {
  const bool tied = directions.size() > 0;
  MatrixXd system = tied ? MatrixXd(root * directions) : root;
  const VectorXd scale = minimise::power_of_two_scales(system);
  system *= scale.asDiagonal();
  const Index n = system.cols();
  const dense::RealPivotedQr qr(system, 16.0 * static_cast<double>(n) * std::numeric_limits<double>::epsilon());
  const Index rank = qr.rank();
  MatrixXd triangle = qr.triangle();
  const double least = rank > 0 ? std::abs(triangle(rank - 1, rank - 1)) : 1.0;
  // θ of w, columns in the order of the pivots.
  const MatrixXd scaled = scale.asDiagonal() * MatrixXd(qr.permutation());
  const MatrixXd to_theta = tied ? MatrixXd(directions * scaled) : scaled;

  TiedLeastSquares out;
  out.condition = rank == n ? std::abs(triangle(0, 0)) / least : std::numeric_limits<double>::infinity();
  const MatrixXd fixed = triangle.topLeftCorner(rank, rank);
  if (rank < n) {
    MatrixXd free(n, n - rank);
    free.topRows(rank) = -fixed.triangularView<Eigen::Upper>().solve(triangle.topRightCorner(rank, n - rank));
    free.bottomRows(n - rank).setIdentity();
    out.null_space = to_theta * free;
    triangle.bottomRightCorner(n - rank, n - rank) = 1e-3 * least * MatrixXd::Identity(n - rank, n - rank);
  } else {
    out.null_space.resize(theta.size(), 0);
  }
  out.basis = to_theta * triangle.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(n, n));
  out.theta = tied ? VectorXd(offset + directions * (scale.asDiagonal() * qr.solve(root * (theta - offset)))) : theta;
  return out;
}

}  // namespace jointid::ident
