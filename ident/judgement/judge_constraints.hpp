#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ident/plan/plan.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// An estimate that no constraint moved, free of bias to first order, by some lines.
struct FreeEstimate {
  std::vector<double> theta;  ///< scaled unknowns
  Eigen::MatrixXd covariance;  ///< by the scatter of the lines' gradients
  Eigen::MatrixXd cautious;    ///< the same where lines that decide alone make it larger, if that is known
  std::size_t lines = 0;       ///< whose scatter they are
  bool from_knowledge = true;  ///< files or scene state the noise; else it is the scatter of neighbouring lines
};

/// What chance leaves of the cost of constraints: Hotelling's T² of `equations` of them by a covariance of so many lines, exceeded
/// once in a thousand times.
double likely_cost(std::size_t equations, std::size_t lines);

/// Doubtful, naming the worst constraint, where the data contradict those of the scene: where the nearest joint that meets them is
/// further from the free estimate, in the metric of its cautious covariance, than likely_cost(). A thousandth of each unknown is added to
/// its error (axes and units are no better). Stated eigenfrequencies have their own error: that of H_bb there and of its
/// interpolation; doubtful, too, where that error moves an unknown by more than five of its standard deviations. `theta`: the
/// constrained estimate. `own`: the unknowns of the method without constraints; empty: not known.
void judge_constraints(const Plan& plan, const FreeEstimate& free, const std::vector<double>& own, const std::vector<double>& theta,
                       Solution& out);

/// The same where the errors of the FRFs are not known: Admissibility::chi_square, by the scatter of the equations' residuals. Noise
/// biases linear estimates beyond that, so five deviations are asked for, and that an unknown moved by a hundredth of the largest
/// of its matrix and unit. `free`: the unknowns without constraints; empty: not known.
void judge_constraints_by_residuals(const Plan& plan, const std::vector<double>& free, const std::vector<double>& theta, Solution& out);

/// The same for method likelihood: the rise of χ² by the variances of the FRFs. `ratio`: χ² over degrees of freedom; above 1 it
/// scales the variances.
void judge_constraints_by_variances(const Plan& plan, double ratio, Solution& out);

}  // namespace jointid::ident
