#include "ident/likelihood/bound.hpp"

#include <cmath>
#include <limits>

#include "base/eigen.hpp"
#include "ident/likelihood/bound_of.hpp"
#include "ident/likelihood/covariance.hpp"
#include "ident/likelihood/likelihood_plan.hpp"
#include "ident/null_space.hpp"

namespace jointid::ident {

std::vector<double> bound_of(const Plan& plan, const Eigen::MatrixXd& information) {
  const Eigen::MatrixXd covariance = covariance_of(information), free = null_space_of(information);
  std::vector<double> bound;
  for (std::size_t column = 0; column < plan.columns->size(); ++column) {
    const auto c = at(column);
    bound.push_back(std::sqrt(covariance(c, c)) * plan.unscale(column));
  }
  LinearSolution fixed;
  if (free.cols() > 0) tell_null_space(free, fixed);
  for (const std::size_t column : fixed.undetermined) bound[column] = std::numeric_limits<double>::infinity();
  return bound;
}

std::vector<double> scaled(const Plan& plan, const std::vector<double>& values) {
  std::vector<double> theta;
  for (std::size_t column = 0; column < values.size(); ++column) theta.push_back(values[column] / plan.unscale(column));
  return theta;
}

void read_observations(Plan& plan, const Control& control) {
  plan.likelihood->observations->read(plan.lines, [&](std::size_t done) {
    stop_if(control.interrupted);
    if (control.progress) control.progress("reading", done, plan.lines.size());
  });
}

LikelihoodEstimator make_estimator(Plan& plan, const Control& control, std::shared_ptr<const std::string> stage) {
  LikelihoodEstimator estimator(*plan.likelihood->observations, plan.restriction, *plan.columns, plan.assembly_spec.omega0,
                                control.threads);
  estimator.set_priors(plan.likelihood->priors);
  if (control.interrupted || control.progress) {
    estimator.set_line_watch([&control, stage = std::move(stage)](std::size_t begun, std::size_t lines) {
      stop_if(control.interrupted);
      if (control.progress) control.progress(stage ? stage->c_str() : "likelihood", begun, lines);
    });
  }
  return estimator;
}

std::vector<double> cramer_rao_bound(Plan& plan, const std::vector<double>& values, const Control& control) {
  read_observations(plan, control);
  return bound_of(plan, make_estimator(plan, control).information_at(scaled(plan, values)));
}

}  // namespace jointid::ident
