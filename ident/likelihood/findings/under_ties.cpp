#include "ident/likelihood/findings/under_ties.hpp"

#include "ident/admissible/admissible_fit.hpp"
#include "minimise/linear/covariance.hpp"
#include "minimise/linear/null_space.hpp"

namespace jointid::ident {
namespace {

/// The information on the unknowns that the ties leave.
Eigen::MatrixXd within_ties(const Plan& plan, const Eigen::MatrixXd& information) {
  const Eigen::MatrixXd& directions = plan.admissible->directions;
  return directions.transpose() * information * directions;
}

}  // namespace

bool tied(const Plan& plan) { return plan.admissible && !plan.admissible->ties.empty(); }

Eigen::MatrixXd covariance_under_ties(const Plan& plan, const Eigen::MatrixXd& information) {
  if (!tied(plan)) return minimise::covariance_of(information);
  const Eigen::MatrixXd& directions = plan.admissible->directions;
  return directions * minimise::covariance_of(within_ties(plan, information)) * directions.transpose();
}

minimise::LinearSolution with_rank(const Plan& plan, const LikelihoodFit& fit) {
  minimise::LinearSolution linear;
  linear.y = fit.theta;
  const Eigen::MatrixXd free = tied(plan)
                                   ? plan.admissible->directions * minimise::null_space_of(within_ties(plan, fit.information))
                                   : minimise::null_space_of(fit.information);
  linear.rank = fit.theta.size() - static_cast<std::size_t>(free.cols());
  if (free.cols() > 0) minimise::tell_null_space(free, linear);
  return linear;
}

}  // namespace jointid::ident
