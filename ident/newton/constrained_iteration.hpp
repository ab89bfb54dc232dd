#pragma once

#include "ident/admissible/admissible_fit.hpp"
#include "ident/judgement/constrained_scatter.hpp"
#include "ident/newton/iteration.hpp"
#include "ident/result/admissibility.hpp"
#include "minimise/linear/linear_solution.hpp"

namespace jointid::ident {

/// From where another iteration ended to the minimum over the joints of `set`: Gauss–Newton steps with the weights and lines of
/// damped_newton(), each to the minimum of the damped linearised problem over the set (nearest_admissible()), so that no point is
/// outside. `start` itself is moved to the nearest joint of the set first. `iterations` are added to those it takes.
NewtonFit constrained_newton(ResponseProblem& problem, const AdmissibleSet& set, const std::vector<double>& start,
                             const NewtonOptions& options, std::size_t iterations);

/// How the minimum q under constraints scatters where the free one has this covariance of the scaled unknowns θ, by the linearised
/// problem at q.
std::optional<ConstrainedScatter> scatter_under_constraints(const AdmissibleSet& set, ResponseProblem& problem,
                                                            const std::vector<double>& q, const Eigen::MatrixXd& covariance);

/// What the constraints cost at their minimum q, by the linearised problem there: against its minimum without them, over the mean
/// square of the residuals. Rank and free directions of `linear` become those of the unknowns that the ties leave.
Admissibility state_constraints(const Plan& plan, ResponseProblem& problem, const std::vector<double>& q,
                                minimise::LinearSolution& linear);

}  // namespace jointid::ident
