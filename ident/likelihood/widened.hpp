#pragma once

#include <Eigen/Core>

#include "ident/likelihood/errors/intervals.hpp"
#include "ident/likelihood/fitted.hpp"

namespace jointid::ident {

/// What is in the intervals beside the noise that variances tell.
struct Widened {
  Intervals intervals;
  bool includes_misfit = false;
  double likely = 0.0;
};

/// `information`: of the unknowns, the joint's and others. Tells `out` why intervals are wider than the noise.
Widened widened(const Plan& plan, const Fitted& all, const Eigen::MatrixXd& information, const Control& control, Solution& out);

}  // namespace jointid::ident
