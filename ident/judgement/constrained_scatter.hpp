#pragma once

#include <Eigen/Core>
#include <optional>

#include "ident/admissible/admissible_set.hpp"
#include "ident/judgement/judge_constraints.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"

namespace jointid::ident {

/// How an estimate under constraints scatters: the covariance of the scaled unknowns is deviations·deviationsᵀ. An unknown that
/// inequalities hold does not scatter; it has the deviations without constraints. One that ties state has none.
struct ConstrainedScatter {
  Eigen::MatrixXd deviations;  ///< [unknowns × groups of lines, or free directions]

  Eigen::VectorXd variances() const { return deviations.rowwise().squaredNorm(); }
  Eigen::MatrixXd covariance() const { return deviations * deviations.transpose(); }
};

/// Of a linear estimate, with one group of lines after the other left out (LineJackknife). Empty with fewer than four lines, and
/// where a group cannot be left out: where the rank is less then, or the constrained problem does not converge.
std::optional<ConstrainedScatter> constrained_scatter(const Plan& plan, std::size_t most_lines, const Control& control);

/// Of an iterated one, linearised: half of what the nearest joint in the metric ‖R(θ − θ̂)‖ moves by when the free estimate θ̂ goes one
/// standard deviation up and down each principal direction of its covariance. Empty where that does not converge.
std::optional<ConstrainedScatter> constrained_scatter(const AdmissibleSet& set, const Eigen::VectorXd& theta,
                                                      const Eigen::MatrixXd& covariance, const Eigen::MatrixXd& root, double unit);

/// The free estimate moved to the nearest joint that meets the constraints, with the covariance of `scatter`. Stated eigenfrequencies are
/// left aside: what such a condition moves under noise counts as error.
FreeEstimate under_constraints(const Plan& plan, const FreeEstimate& free, const ConstrainedScatter& scatter);

}  // namespace jointid::ident
