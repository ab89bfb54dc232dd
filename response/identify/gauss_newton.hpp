#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

namespace jointid::response {

/// Residuals in standard deviations, and their derivatives by the unknowns.
struct Linearised {
  Eigen::VectorXd residual;
  Eigen::MatrixXd jacobian;
};

/// Nothing where the residuals are not defined.
using Residuals = std::function<std::optional<Linearised>(const Eigen::VectorXd& unknowns)>;

struct GaussNewtonOptions {
  int most_steps = 100;
  double tolerance = 1e-9;  ///< largest element of the last step
};

struct GaussNewtonResult {
  bool defined = false;  ///< whether the residuals were at the start
  bool converged = false;
  int steps = 0;
  Eigen::VectorXd unknowns;
  Linearised at;  ///< the unknowns
};

/// −(JᵀJ + damping·D²)⁺Jᵀr, D the norms of J's columns; no element is longer than 1.
Eigen::VectorXd damped_step(const Linearised& at, double damping);

/// min Σr² by Gauss–Newton steps, damped (Levenberg–Marquardt, columns of the Jacobian scaled) while they do not lower it and
/// never longer than 1; unknowns that no residual depends on are left. Near the end, where a step would lower Σr² by less than
/// 1e-10 of it, full steps are taken as long as they become shorter.
GaussNewtonResult gauss_newton(const Residuals& residuals, const Eigen::VectorXd& start, const GaussNewtonOptions& options = {});

}  // namespace jointid::response
