#pragma once

#include "response/harmonic/condensed_equations.hpp"

namespace jointid::response {

struct NewtonOptions {
  int most_steps = 60;
  double tolerance = 1e-13;  ///< largest last step over the largest amplitude, joint by joint
};

struct NewtonResult {
  bool converged = false;
  int steps = 0;
  double residual = 0.0;  ///< ‖R‖ over the sizes of its terms
  Eigen::VectorXd motion;
};

/// Newton's method with the exact Jacobian for R(Q) = 0, steps halved until ‖R‖ (joint by joint over what the force alone would
/// move) falls. Never throws for want of convergence: the result says so.
NewtonResult newton(const CondensedEquations& equations, const HarmonicLine& line, double level, Eigen::VectorXd start,
                    const NewtonOptions& options = {});

}  // namespace jointid::response
