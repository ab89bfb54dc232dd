#include "ident/likelihood/likelihood.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <memory>
#include <optional>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "base/stopwatch.hpp"
#include "ident/admissible/admissible_fit.hpp"
#include "ident/admissible/outcome.hpp"
#include "ident/judgement/judge.hpp"
#include "ident/judgement/tell_errors.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/errors/gain_scores.hpp"
#include "ident/likelihood/errors/interval_notes.hpp"
#include "ident/likelihood/findings/best_joint.hpp"
#include "ident/likelihood/findings/bootstrap.hpp"
#include "ident/likelihood/findings/bound_of.hpp"
#include "ident/likelihood/findings/constrained_intervals.hpp"
#include "ident/likelihood/findings/findings.hpp"
#include "ident/likelihood/findings/fit_suspects.hpp"
#include "ident/likelihood/findings/identifiability.hpp"
#include "ident/likelihood/findings/joint_part.hpp"
#include "ident/likelihood/findings/systematic_estimates.hpp"
#include "ident/likelihood/findings/under_ties.hpp"
#include "ident/likelihood/findings/variance_sources.hpp"
#include "ident/likelihood/fit/starts.hpp"
#include "ident/likelihood/fitted.hpp"
#include "ident/likelihood/parts/likelihood_by_parts.hpp"
#include "ident/likelihood/widened.hpp"
#include "ident/plan/interpret.hpp"
#include "ident/plan/prediction.hpp"
#include "ident/result/minima.hpp"

namespace jointid::ident {
namespace {

/// Where the starts ended. Two ends are the same minimum when they are less than a standard deviation apart, and fit equally well
/// when no test at 95 % could tell them apart by χ².
MinimumSearch search_of(const Plan& plan, const LikelihoodFit& fit) {
  const auto same = [&](const FoundMinimum& a, const FoundMinimum& b) {
    Eigen::VectorXd apart(at(fit.theta.size()));
    for (std::size_t c = 0; c < fit.theta.size(); ++c) apart[at(c)] = a.values[c] - b.values[c];
    return apart.dot(fit.information * apart) < 1.0;
  };
  MinimumList minima;
  for (const LikelihoodFit::End& end : fit.ends) minima.add({end.loss, 1, end.theta}, same);
  const boost::math::chi_squared_distribution<double> distribution(static_cast<double>(fit.theta.size()));
  MinimumSearch search = minima.result(fit.loss + boost::math::quantile(distribution, 0.95));
  for (FoundMinimum& minimum : search.minima) {
    for (std::size_t c = 0; c < minimum.values.size(); ++c) minimum.values[c] *= plan.unscale(c);
  }
  return search;
}

/// Replaces the Cramér–Rao errors by those of a bootstrap; keeps them, and says so, when too many replicates fail.
void bootstrap_errors(const Plan& plan, const LinearisedLikelihood& fitted, const LikelihoodFit& fit, const Control& control,
                      Solution& out) {
  const std::vector<Replicate> replicates = bootstrap(plan, fitted, fit, control);
  const auto usable = static_cast<std::size_t>(std::ranges::count_if(replicates, &Replicate::usable));
  if (10 * usable < 9 * replicates.size()) {
    out.message += "Only " + std::to_string(usable) + " of " + std::to_string(replicates.size()) +
                   " bootstrap replicates converged: the intervals are those of the Cramér–Rao bound.";
    return;
  }
  out.intervals = IntervalKind::bootstrap;
  for (std::size_t column = 0; column < out.unknowns.size(); ++column) {
    Estimate& estimate = out.unknowns[column];
    if (!estimate.determined) continue;
    const double scale = plan.unscale(column);
    const auto [error, ci95] = bootstrap_error(replicates, column, fit.theta[column], *estimate.std_error / scale);
    estimate.std_error = error * scale;
    estimate.ci95 = {ci95[0] * scale, ci95[1] * scale};
  }
}

/// Standard errors do not hold a bias of H1, and intervals that of the files where it is seen.
void tell_force_noise(Solution& out) {
  const auto found = std::ranges::find(out.suspects, SuspectKind::force_noise, &Suspect::kind);
  if (out.status != Status::ok || found == out.suspects.end()) return;
  tell(out, Status::doubtful, "Noise of the force's signal: " + found->evidence + ". Use H2 or Hv, or a force with less noise.");
}

/// What the fit and its intervals say beside the estimates.
void tell_fit(const Plan& plan, const Fitted& all, const LikelihoodFit& fit, const Widened& widest, Solution& out) {
  out.fit.lines = plan.lines.size();
  out.fit.equations_used = equations_used(*likelihood_plan(plan)->observations, fit.line_weight);
  out.fit.iterations = fit.iterations;
  out.fit.chi_square = all.chi_square;
  out.fit.chi_square->likely = widest.likely;
  if (all.tried && all.may_widen(plan))
    out.suspects = fit_suspects(*all.tried, all.without, widest.intervals.covariance(), all.found.fit.theta);
  tell_force_noise(out);
}

void tell_convergence(const Plan& plan, const LikelihoodFit& fit, Solution& out) {
  const bool finite = std::ranges::all_of(fit.theta, [](double value) { return std::isfinite(value); });
  if ((!fit.converged && !fit.hopeless) || !finite) {
    out.status = Status::not_converged;
    out.message = finite ? "The likelihood did not converge."
                         : "The likelihood broke down: is a line on a resonance without any damping? Leave such lines out.";
  }
  out.used.accumulator_bytes = likelihood_plan(plan)->observations->bytes() + fit.bytes;
  if (tied(plan))
    out.fit.chi_square->degrees_of_freedom +=
        static_cast<double>(fit.theta.size()) - static_cast<double>(plan.admissible->directions.cols());
  if (plan.admissible) tell_outcome(plan, out);
}

/// What Detail::full asks for. `information`: of the unknowns, the joint's and others.
void tell_details(const Plan& plan, const Fitted& all, const Widened& widest, const Eigen::MatrixXd& information, const Control& control,
                  Solution& out) {
  stop_if(control.interrupted);
  if (control.progress) control.progress("identifiability", 0, 0);
  const Stopwatch watch(out.runtime_s.identifiability);
  out.identifiability = identifiability_of(plan, all.found, widest.intervals.covariance(), widest.likely, out);
  tell_calibration(plan, information, out);
  if (all.tried) tell_gains(suspect_gains(*all.tried, all.found.fit.theta.size()), out);
}

void judge(const Plan& plan, const Fitted& all, const LikelihoodFit& fit, const Widened& widest,
           const Eigen::MatrixXd& information, const Control& control, Solution& out) {
  const Stopwatch watch(out.runtime_s.check);
  if (all.without) tell_common_gain(*all.without, out);
  tell_model_errors(plan, all.found.fit, information, out);
  judge_likelihood(plan,
                   {.theta = fit.theta,
                    .covariance = widest.intervals.covariance(),
                    .hopeless = fit.hopeless,
                    .several_minima = !joint_is_reached(plan),
                    .likely = widest.likely,
                    .ratio = all.ratio,
                    .includes_misfit = widest.includes_misfit},
                   control, out);
}

void estimate(const Plan& plan, const Control& control, Solution& out) {
  const Clock::time_point start = Clock::now();
  read_observations(plan, control);
  out.runtime_s.read = seconds_since(start);
  out.variances = variance_sources(plan);
  const auto stage = std::make_shared<std::string>("starting");
  Fitted all = fitted(plan, control, stage, out);
  *stage = "standard errors";
  const Clock::time_point solved = Clock::now();
  if (all.may_widen(plan) || (all.found.fit.converged && control.detail == Detail::full))
    try_errors_of(plan, control, all);
  if (all.may_widen(plan)) fit_with_gain(plan, control, stage, all);
  const Eigen::MatrixXd information = all.is_own(plan) ? all.found.godambe_information(std::move(all.nearby)) : all.found.fit.information;
  const LikelihoodFit fit = joint_part(all.found.fit, plan.columns->size());
  interpret(plan, with_rank(plan, fit), out);
  out.systematic = systematic_estimates(plan, all.found.fit, information);
  const Widened widest = widened(plan, all, information, control, out);
  widest.intervals.state(plan, out);
  if (plan.admissible && fit.converged)
    state_constrained_intervals(plan, fit.theta, all.pull, joint_information(information, plan.columns->size()),
                                widest.intervals.covariance(), out);
  tell_fit(plan, all, fit, widest, out);
  if (control.so_far) control.so_far(out);
  if (plan.scene.identify.bootstrap > 0 && !fit.hopeless) bootstrap_errors(plan, all.found, fit, control, out);
  out.runtime_s.intervals = seconds_since(solved);
  if (plan.scene.identify.starts > 0) out.search = search_of(plan, fit);
  tell_convergence(plan, fit, out);
  if (control.so_far) control.so_far(out);
  if (control.detail == Detail::full) tell_details(plan, all, widest, information, control, out);
  if (control.judgement != Judgement::none) judge(plan, all, fit, widest, information, control, out);
}

class LikelihoodMethod final : public LikelihoodPlan {
 public:
  void solve(const Plan& plan, const Control& control, Solution& out) override {
    estimate(plan, control, out);
    tell_and_predict(plan, control, out);
  }
};

}  // namespace

PlannedMethod plan_likelihood(const Plan& plan, const StartPlanner& plan_start) {
  const auto plan_whole = [&] { return plan_observations(plan, plan_start, std::make_unique<LikelihoodMethod>()); };
  if (!goes_by_parts(plan)) {
    PlannedMethod whole = plan_whole();
    return is_better_by_parts(plan, whole.cost) ? quicker(plan, plan_by_parts(plan, plan_start), std::move(whole))
                                                : std::move(whole);
  }
  PlannedMethod parts = plan_by_parts(plan, plan_start);
  if (!may_be_quicker_whole(plan, parts)) return parts;
  std::optional<PlannedMethod> whole;
  try {
    whole = plan_whole();
  } catch (const InputError&) {
    // It asks more of the joint.
  }
  return whole ? quicker(plan, std::move(parts), std::move(*whole)) : std::move(parts);
}

}  // namespace jointid::ident
