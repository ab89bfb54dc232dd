#pragma once

#include <Eigen/Core>

#include "ident/likelihood/fit/likelihood_fit.hpp"
#include "ident/plan/plan.hpp"
#include "minimise/linear/linear_solution.hpp"

namespace jointid::ident {

/// Whether unknowns of the scene are tied to each other.
bool tied(const Plan& plan);

/// Of all unknowns. Inequalities are left out of it: they make errors smaller, and the distribution is no longer normal then.
Eigen::MatrixXd covariance_under_ties(const Plan& plan, const Eigen::MatrixXd& information);

/// The estimates and what of them the information fixes.
minimise::LinearSolution with_rank(const Plan& plan, const LikelihoodFit& fit);

}  // namespace jointid::ident
