#pragma once

#include <Eigen/Core>
#include <deque>

namespace jointid::ident {

/// Steps to a minimum from its information matrix, which leaves out the curvature of what is measured, corrected by what gradients
/// along the last steps tell of that curvature: limited-memory BFGS (Nocedal 1980) that begins at the information. Gauss–Newton
/// steps alone approach at a constant rate where noise is large.
class SecantSteps {
 public:
  /// H g of the inverse Hessian so far, for a gradient g that points downhill. Without steps noted: Gauss–Newton.
  Eigen::VectorXd step(const Eigen::MatrixXd& information, const Eigen::VectorXd& gradient) const;

  /// A step taken and by how much the gradient fell along it. Left out where that is against the curvature of the information or
  /// far from it: there the minimum is not yet near.
  void note(const Eigen::VectorXd& step, const Eigen::VectorXd& fall, const Eigen::MatrixXd& information);

  void forget() { pairs_.clear(); }

 private:
  struct Pair {
    Eigen::VectorXd step, fall;
  };
  std::deque<Pair> pairs_;  ///< oldest first
};

}  // namespace jointid::ident
