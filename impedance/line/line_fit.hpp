#pragma once

#include "ident/likelihood/model/line_model.hpp"
#include "impedance/line/line_value.hpp"

namespace jointid::impedance {

/// Z at a line by maximum likelihood with the true FRFs of the parts as unknowns (docs/joint-line-by-line.md §4):
/// Levenberg–Marquardt over both. The covariance is the inverse of the information there: at the true FRFs the Cramér–Rao bound.
struct LineFit {
  LineValue value;
  bool converged = false;
  std::size_t steps = 0;
  double last_step = 0.0;  ///< in standard deviations
};

/// `joint` has the real, then the imaginary parts of z as its unknowns; `start` is z. Ends with a step below `tolerance` standard
/// deviations. Not for several threads at once, as `model`.
LineFit fit_line(const ident::LineData& data, const ident::JointImpedance& joint, const Eigen::VectorXcd& start,
                 ident::LineModel& model, double tolerance = 1e-7);

}  // namespace jointid::impedance
