#pragma once

#include <optional>

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
  ident::LineState state{};  ///< the true FRFs there
};

/// `joint` has the real, then the imaginary parts of z as its unknowns; `start` is z. Ends with a step below `tolerance` standard
/// deviations. Not for several threads at once, as `model`.
LineFit fit_line(const ident::LineData& data, const ident::JointImpedance& joint, const Eigen::VectorXcd& start,
                 ident::LineModel& model, double tolerance = 1e-7);

/// By how much χ² would fall with the unknowns of `wider` in place of those of `fit`, whose Z is `z` by the elements of `wider`: to first
/// order, gᵀI⁻¹g of its gradient and information there (Rao's score test). Empty where the FRFs are not determined.
std::optional<double> fall_with(const ident::LineData& data, const ident::JointImpedance& wider, const Eigen::VectorXcd& z,
                                const LineFit& fit, ident::LineModel& model);

}  // namespace jointid::impedance
