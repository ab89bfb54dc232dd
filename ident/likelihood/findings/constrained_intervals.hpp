#pragma once

#include <Eigen/Core>
#include <vector>

#include "ident/plan/plan.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// Replaces the intervals of a plan with inequalities by those of the profile likelihood under them (profile_intervals()); with
/// more than 60 unknowns, of those with bounds of their own, by the highest density between these. `theta` is the constrained
/// estimate in scaled unknowns, `pull` what the inequalities pull it by: the gradient of half of χ² there. `information` and
/// `covariance`: as the intervals without inequalities have them.
void state_constrained_intervals(const Plan& plan, const std::vector<double>& theta, const Eigen::VectorXd& pull,
                                 const Eigen::MatrixXd& information, const Eigen::MatrixXd& covariance, Solution& out);

}  // namespace jointid::ident
