#include "ident/likelihood/fitted.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/eigen.hpp"
#include "base/stopwatch.hpp"
#include "ident/admissible/admissible_fit.hpp"
#include "ident/admissible/outcome.hpp"
#include "ident/judgement/whitened_fit.hpp"
#include "ident/likelihood/bundle/bundle.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/errors/interval_notes.hpp"
#include "ident/likelihood/findings/best_joint.hpp"
#include "ident/likelihood/findings/bound_of.hpp"
#include "ident/likelihood/findings/chi_square.hpp"
#include "ident/likelihood/findings/findings.hpp"
#include "ident/likelihood/findings/identifiability.hpp"
#include "ident/likelihood/findings/joint_part.hpp"
#include "ident/likelihood/fit/starts.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

/// Of the unknowns of a fit, by the inverse of its information.
double largest_relative_error(const Plan& plan, const LikelihoodFit& whole) {
  const LikelihoodFit fit = joint_part(whole, plan.columns->size());
  std::vector<double> values = fit.theta;
  for (std::size_t c = 0; c < values.size(); ++c) values[c] *= plan.unscale(c);
  std::vector<std::size_t> all(values.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return std::sqrt(relative_covariance(plan, minimise::covariance_of(fit.information), values, all).diagonal().maxCoeff());
}

LinearisedLikelihood fit_by_solver(const Plan& plan, LikelihoodEstimator estimator, const Control& control, FollowOptions options,
                                   std::string& stage, double& start_time) {
  const FitWatcher watch = [&](std::size_t iteration) {
    stop_if(control.interrupted);
    stage = "iteration " + std::to_string(iteration);
  };
  const Clock::time_point begun = Clock::now();
  const Starts starts = starts_of(plan, estimator, control);
  start_time = seconds_since(begun);
  if (plan.solver == Solver::gauss_helmert) {
    const Follow usual = joint_is_reached(plan) ? Follow::until_it_fits : Follow::until_reached_twice;
    options.follow = plan.scene.identify.starts > 0 ? Follow::all : usual;
    options.doubtful = [&plan](const LikelihoodFit& fit) { return largest_relative_error(plan, fit) >= nonlinear_error; };
    return std::move(estimator).run(starts, watch, std::move(options));
  }
  const std::vector<double> start = *starts(0);
  LinearisedLikelihood whitened = std::move(estimator).run_whitened(start, watch, std::move(options));
  LikelihoodFit fit = whitened.fit;
  if (plan.solver == Solver::ceres) {
    fit = adjust_bundle(*likelihood_plan(plan)->observations, plan.restriction, *plan.columns, plan.omega0, fit, watch);
  }
  const bool asks_lines = control.detail == Detail::full || plan.scene.identify.bootstrap > 0 || plan.admissible;
  return std::move(whitened).moved_to(std::move(fit), asks_lines);
}

Fitted with_chi_square(const Plan& plan, LinearisedLikelihood fitted) {
  const LikelihoodPlan& own = *likelihood_plan(plan);
  ChiSquare chi_square = chi_square_of(*own.observations, own.priors, fitted.fit);
  const double ratio = fitting_ratio(chi_square, fitted.fit);
  return {std::move(fitted), std::move(chi_square), ratio};
}

/// Whether a gain explains the misfit beyond its expectation, or half of it.
bool explains(double with, double without, double freedom) {
  const auto excess = [&](double ratio) { return ratio - 1.0 - 3.0 * std::sqrt(2.0 / std::max(1.0, freedom)); };
  return excess(with) < 0.5 * std::max(0.0, excess(without));
}

}  // namespace

Fitted fitted(const Plan& plan, const Control& control, const std::shared_ptr<std::string>& stage, Solution& out) {
  const Clock::time_point start = Clock::now();
  BestJoint best(plan, out, control);
  FollowOptions options;
  if (control.so_far) options.listener = [&best](const LikelihoodFit& found, double loss) { best.tell(found, loss); };
  options.gives_up = !has_scales(plan);
  if (control.judgement == Judgement::data && options.gives_up) {
    options.second_opinion = [&plan](const std::vector<double>& theta) { return beyond_any_joint(plan, theta); };
  }
  LinearisedLikelihood found =
      fit_by_solver(plan, make_estimator(plan, control, stage), control, std::move(options), *stage, out.runtime_s.start);
  Eigen::VectorXd pull = Eigen::VectorXd::Zero(at(plan.columns->size()));
  if (plan.admissible) {
    *stage = "constraining";
    auto [constrained, admissible] =
        std::move(found).constrained(*plan.admissible, [&](std::size_t) { stop_if(control.interrupted); });
    found = std::move(constrained);
    out.admissibility = outcome_of(*plan.admissible, admissible, 1.0);
    out.admissibility->from_variances = true;
    for (const Eigen::VectorXd& force : admissible.forces) {
      if (force.size() > 0) pull += force;
    }
  }
  out.runtime_s.solve = seconds_since(start) - out.runtime_s.start;
  Fitted all = with_chi_square(plan, std::move(found));
  all.pull = std::move(pull);
  return all;
}

void try_errors_of(const Plan& plan, const Control& control, Fitted& all) {
  if (all.is_own(plan)) all.nearby = all.found.begin_godambe();
  all.tried = try_errors(plan, all.found, all.found.fit, all.ratio, control, all.nearby);
}

void fit_with_gain(const Plan& plan, const Control& control, const std::shared_ptr<std::string>& stage, Fitted& all) {
  const FileGain* const gain = all.tried && !all.tried->is_calibration_stated ? telling_gain(all.tried->files) : nullptr;
  if (gain == nullptr || has_better_explanation(*all.tried, *gain)) return;
  const FileGain chosen = *gain;
  std::vector<double> start = all.found.fit.theta;
  for (std::size_t c = 0; c < start.size(); ++c) start[c] += chosen.gain * chosen.answer[at(c)];
  auto assumed = std::make_unique<AssumedGain>(plan, chosen.file);
  all.nearby = {};  // the observations are weighed anew
  start.push_back(chosen.gain / usual_calibration);
  const Starts only = [&start](std::size_t k) { return k == 0 ? std::optional(start) : std::nullopt; };
  Fitted more = with_chi_square(
      plan, make_estimator(plan, control, stage).run(only, [&](std::size_t) { stop_if(control.interrupted); }));
  if (!more.found.fit.converged || !explains(more.ratio, all.ratio, more.chi_square.degrees_of_freedom)) return;
  more.found.fit.iterations += all.found.fit.iterations;
  try_errors_of(plan, control, more);
  more.gain = std::move(assumed);
  more.without = chosen;
  all = std::move(more);
}

}  // namespace jointid::ident
