#pragma once

#include <Eigen/Core>

namespace jointid::ident {

/// min ‖R(θ − θ̂)‖ over θ = offset + directions·w.
struct TiedLeastSquares {
  Eigen::VectorXd theta;  ///< where it is least
  /// From there, ‖R(theta + basis·x − θ̂)‖² is its least value plus ‖x‖². Directions that R does not fix count as if they were a
  /// thousand times worse known than the worst of the others.
  Eigen::MatrixXd basis;
  Eigen::MatrixXd null_space;  ///< of R over the directions, as directions of θ; no columns when R fixes them all
  double condition = 0.0;      ///< of R·directions, columns scaled, bounded from below by the pivots
};

/// `root` is R, [any × columns]; `offset` and `directions` are empty where there are no ties.
TiedLeastSquares tied_least_squares(const Eigen::MatrixXd& root, const Eigen::VectorXd& theta, const Eigen::VectorXd& offset,
                                    const Eigen::MatrixXd& directions);

}  // namespace jointid::ident
