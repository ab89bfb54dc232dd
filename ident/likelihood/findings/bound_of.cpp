#include "ident/likelihood/findings/bound_of.hpp"

#include <cmath>
#include <limits>

#include "base/eigen.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/findings/joint_part.hpp"
#include "ident/plan/joint_guess.hpp"
#include "minimise/linear/covariance.hpp"
#include "minimise/linear/null_space.hpp"

namespace jointid::ident {

std::vector<double> bound_of(const Plan& plan, const Eigen::MatrixXd& information) {
  const Eigen::MatrixXd of_joint = joint_information(information, plan.columns->size());
  const Eigen::MatrixXd covariance = minimise::covariance_of(of_joint), free = minimise::null_space_of(of_joint);
  std::vector<double> bound;
  for (std::size_t column = 0; column < plan.columns->size(); ++column) {
    const auto c = at(column);
    bound.push_back(std::sqrt(covariance(c, c)) * plan.unscale(column));
  }
  minimise::LinearSolution fixed;
  if (free.cols() > 0) minimise::tell_null_space(free, fixed);
  for (const std::size_t column : fixed.undetermined) bound[column] = std::numeric_limits<double>::infinity();
  return bound;
}

void read_observations(const Plan& plan, const Control& control) {
  const auto between = [&](std::size_t done) {
    stop_if(control.interrupted);
    if (control.progress) control.progress("reading", done, plan.lines.size());
  };
  likelihood_plan(plan)->observations->read(plan.lines, between, control.shares);
}

void read_for_bound(const Plan& plan, const Control& control) {
  const auto& noise = plan.scene.noise;
  const bool apart = noise && (!noise->frf_model.reciprocal || noise->frf_model.kind == frf::NoiseKind::hammer);
  if (apart) likelihood_plan(plan)->observations->take_pairs_apart();
  read_observations(plan, control);
}

LikelihoodEstimator make_estimator(const Plan& plan, const Control& control, std::shared_ptr<const std::string> stage) {
  EstimatorOptions options{.threads = control.threads, .priors = likelihood_plan(plan)->priors};
  if (control.interrupted || control.progress) {
    options.line_watch = [&control, stage = std::move(stage)](std::size_t begun, std::size_t lines) {
      stop_if(control.interrupted);
      if (control.progress) control.progress(stage ? stage->c_str() : "likelihood", begun, lines);
    };
  }
  return {*likelihood_plan(plan)->observations, plan.restriction, *plan.columns, plan.omega0, std::move(options)};
}

}  // namespace jointid::ident
