#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

namespace jointid::minimise {

/// Residuals in standard deviations, and their derivatives by the unknowns.
struct Linearised {
  Eigen::VectorXd residual;
  Eigen::MatrixXd jacobian;
};

/// One above the other; of each the residuals are the last column.
Linearised stacked(const std::vector<Eigen::MatrixXd>& parts);

/// Nothing where the residuals are not defined.
using Residuals = std::function<std::optional<Linearised>(const Eigen::VectorXd& unknowns)>;

struct GaussNewtonOptions {
  int most_steps = 100;
  double tolerance = 1e-9;  ///< largest element of the last step
  double enough = 0.0;      ///< ends sooner, where a step would move no combination of unknowns by more of its deviations
};

/// Where Gauss–Newton steps end.
class GaussNewtonEnd {
 public:
  enum class What {
    here,       ///< at the present unknowns
    descend,    ///< by steps that lower Σr²
    full_step,  ///< Σr² cannot tell any more: a full step, as long as they become shorter
  };
  explicit GaussNewtonEnd(const GaussNewtonOptions& options) : options_(options) {}

  /// What follows at unknowns with this full step, J times it, and Σr² now and by how much it would fall.
  What judge(const Eigen::VectorXd& full, double deviations, double cost, double gain);
  /// Of the step judged last: whether it is shorter than the one before, whether it is the last one, and whether a Σr² that does
  /// not fall along it is at rounding.
  bool shrinks() const { return shrinks_; }
  bool is_last() const { return is_last_; }
  bool at_rounding() const;

 private:
  GaussNewtonOptions options_;
  double before_ = 1.0, size_ = 0.0;
  bool shrinks_ = false, is_last_ = false;
};

struct GaussNewtonResult {
  bool defined = false;  ///< whether the residuals were at the start
  bool converged = false;
  int steps = 0;
  Eigen::VectorXd unknowns;
  Linearised at;  ///< the unknowns
  /// Of one that ended at a kink of Σr², where no step along the direction of descent lowers it: by how many of their deviations
  /// a step would have moved the unknowns.
  double kink = 0.0;
};

/// −(JᵀJ + damping·D²)⁺Jᵀr, D the norms of J's columns; no element is longer than 1.
Eigen::VectorXd damped_step(const Linearised& at, double damping);

/// min Σr² by Gauss–Newton steps, damped (Levenberg–Marquardt, columns of the Jacobian scaled) while they do not lower it and
/// never longer than 1; unknowns that no residual depends on are left. Near the end, where a step would lower Σr² by less than
/// 1e-10 of it, full steps are taken as long as they become shorter.
GaussNewtonResult gauss_newton(const Residuals& residuals, const Eigen::VectorXd& start, const GaussNewtonOptions& options = {});

}  // namespace jointid::minimise
