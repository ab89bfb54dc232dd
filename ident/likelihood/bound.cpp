#include "ident/likelihood/bound.hpp"

#include <cmath>

#include "ident/likelihood/covariance.hpp"
#include "ident/likelihood/estimator.hpp"
#include "ident/likelihood/likelihood_plan.hpp"

namespace jointid::ident {

std::vector<double> cramer_rao_bound(Plan& plan, const std::vector<double>& values, const Control& control) {
  Observations& observations = *plan.likelihood->observations;
  observations.read(plan.lines, [&](std::size_t) {
    if (control.interrupted && control.interrupted()) throw Interrupted();
  });
  std::vector<double> theta;
  for (std::size_t column = 0; column < values.size(); ++column) theta.push_back(values[column] / plan.unscale(column));
  LikelihoodEstimator estimator(observations, plan.restriction, *plan.columns, plan.assembly_spec.omega0, control.threads);
  const Eigen::MatrixXd covariance = covariance_of(estimator.information_at(theta));
  std::vector<double> bound;
  for (std::size_t column = 0; column < values.size(); ++column) {
    const auto c = static_cast<Eigen::Index>(column);
    bound.push_back(std::sqrt(covariance(c, c)) * plan.unscale(column));
  }
  return bound;
}

}  // namespace jointid::ident
