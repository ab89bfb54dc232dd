#include "ident/likelihood/likelihood.hpp"

#include <algorithm>
#include <array>
#include <boost/math/distributions/chi_squared.hpp>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "base/stopwatch.hpp"
#include "ident/admissible/admissible_fit.hpp"
#include "ident/admissible/outcome.hpp"
#include "ident/equations/linear_plan.hpp"
#include "ident/judgement/judge.hpp"
#include "ident/judgement/tell_errors.hpp"
#include "ident/judgement/whitened_fit.hpp"
#include "ident/likelihood/bundle/bundle.hpp"
#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/likelihood/findings/constrained_intervals.hpp"
#include "ident/likelihood/findings/bootstrap.hpp"
#include "ident/likelihood/findings/bound_of.hpp"
#include "ident/likelihood/errors/chi_square_law.hpp"
#include "ident/likelihood/findings/findings.hpp"
#include "ident/likelihood/errors/gain_scores.hpp"
#include "ident/likelihood/findings/fit_suspects.hpp"
#include "ident/likelihood/findings/identifiability.hpp"
#include "ident/likelihood/errors/interval_notes.hpp"
#include "ident/likelihood/errors/intervals.hpp"
#include "ident/likelihood/findings/joint_part.hpp"
#include "ident/likelihood/findings/systematic_estimates.hpp"
#include "ident/likelihood/findings/variance_sources.hpp"
#include "ident/likelihood/fit/estimator.hpp"
#include "ident/likelihood/fit/predicted_start.hpp"
#include "ident/likelihood/fit/spring_starts.hpp"
#include "ident/likelihood/parts/likelihood_by_parts.hpp"
#include "ident/plan/interpret.hpp"
#include "ident/plan/joint_guess.hpp"
#include "ident/plan/prediction.hpp"
#include "ident/result/minima.hpp"
#include "minimise/linear/covariance.hpp"
#include "minimise/linear/null_space.hpp"
#include "minimise/linear/start_points.hpp"

namespace jointid::ident {
namespace {

using enum weighting::Weighting;

constexpr std::array<std::pair<weighting::Weighting, double>, 4> linear_ways = {{{wb, 0.0}, {wbg, 0.0}, {wbs, 0.1}, {wa, 0.0}}};

/// Linear estimates with one weighting after the other; one estimate where the start is the likelihood by parts.
std::optional<std::vector<double>> linear_start(const Plan& plan, std::size_t k, const Control& control) {
  const Plan& start = *likelihood_plan(plan)->start;
  LinearPlan* const linear = linear_plan(start);
  if (k >= (linear != nullptr ? linear_ways.size() : 1)) return std::nullopt;
  if (linear != nullptr) {
    std::tie(linear->spec.weighting, linear->spec.delta) = linear_ways[k];
    for (AssemblySpec& each : linear->part_specs) std::tie(each.weighting, each.delta) = linear_ways[k];
  }
  return started(plan, start, control);
}

/// Joints that were given or guessed, in sizes that fit.
minimise::StartPoints in_sizes(const std::vector<std::vector<double>>& joints, LikelihoodEstimator& estimator) {
  return {joints, [&](const std::vector<double>& theta) { return estimator.misfit_at(theta); }};
}

/// Where H_jn of the assembly is not measured: the first as it is, then along method "newton" from those in sizes that fit. What
/// the data say of the joint then is far from linear, and its steps come nearer from farther away.
Starts predicted_starts(const Plan& plan, std::optional<std::vector<double>> first, const minimise::StartPoints& points,
                        std::size_t most) {
  return [first = std::move(first), points, most, &plan](std::size_t k) -> std::optional<std::vector<double>> {
    if (k >= most) return std::nullopt;
    if (k == 0 && first) return first;
    return predicted_start(plan, *likelihood_plan(plan)->observations, points(first ? k - 1 : k));
  };
}

bool joint_is_reached(const Plan& plan) { return likelihood_plan(plan)->observations->layout().reaches_joint(); }

/// From the scene's start.
Starts given_starts(const Plan& plan, LikelihoodEstimator& estimator, std::size_t most) {
  const auto points = in_sizes({scaled(plan, joint_values(plan, plan.scene.identify.start, "[identify] start"))}, estimator);
  if (!joint_is_reached(plan)) return predicted_starts(plan, points(0), points, most);
  return [points, most](std::size_t k) { return k < most ? std::optional(points(k)) : std::nullopt; };
}

/// Where H_jn is not measured: from springs, and first from the direct solution when that fits better, as it does without noise.
Starts guessed_starts(const Plan& plan, LikelihoodEstimator& estimator, const std::vector<std::vector<double>>& springs,
                      const Control& control, std::size_t most) {
  const auto points = in_sizes(springs, estimator);
  std::optional direct = linear_start(plan, 0, control);
  if (!(estimator.misfit_at(*direct) < estimator.misfit_at(points(0)))) direct.reset();
  return predicted_starts(plan, std::move(direct), points, most);
}

/// Linear estimates, that which fits best first, then random changes of that one. Where the first nearly fits no other is worked out
/// to compare it with.
Starts linear_starts(const Plan& plan, LikelihoodEstimator& estimator, const Control& control, std::size_t most) {
  constexpr double near = 1.0;
  std::vector<std::vector<double>> found;
  std::ptrdiff_t best = 0;
  double least = 0.0;
  while (found.empty() || least > near) {
    auto next = linear_start(plan, found.size(), control);
    if (!next) break;
    found.push_back(std::move(*next));
    const double misfit = estimator.misfit_at(found.back());
    if (found.size() == 1 || misfit < least) std::tie(best, least) = std::pair(std::ssize(found) - 1, misfit);
  }
  std::rotate(found.begin(), found.begin() + best, found.begin() + best + 1);
  return [&plan, &control, found = std::move(found), most](std::size_t k) -> std::optional<std::vector<double>> {
    if (k >= most) return std::nullopt;
    if (k < found.size()) return found[k];
    if (auto start = linear_start(plan, k, control)) return start;
    const minimise::StartPoints points({found.front()}, [](const std::vector<double>&) { return 0.0; });
    return points(minimise::StartPoints::sizes + k);
  };
}

Starts starts_of(const Plan& plan, LikelihoodEstimator& estimator, const Control& control) {
  const LikelihoodPlan& own = *likelihood_plan(plan);
  const std::size_t wanted = plan.scene.identify.starts;
  const std::size_t of_sizes = wanted > 0 ? wanted : 2 * minimise::StartPoints::sizes;
  if (!own.start) return given_starts(plan, estimator, of_sizes);
  if (!joint_is_reached(plan)) {
    const auto springs = spring_starts(plan, *own.observations);
    if (!springs.empty()) return guessed_starts(plan, estimator, springs, control, of_sizes);
  }
  return linear_starts(plan, estimator, control, wanted > 0 ? wanted : linear_ways.size());
}

/// Of the unknowns of a fit, by the inverse of its information.
double largest_relative_error(const Plan& plan, const LikelihoodFit& whole) {
  const LikelihoodFit fit = joint_part(whole, plan.columns->size());
  std::vector<double> values = fit.theta;
  for (std::size_t c = 0; c < values.size(); ++c) values[c] *= plan.unscale(c);
  std::vector<std::size_t> all(values.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return std::sqrt(relative_covariance(plan, minimise::covariance_of(fit.information), values, all).diagonal().maxCoeff());
}

/// Complex equations of the lines that have a say.
std::size_t equations_used(const Observations& observations, const std::vector<double>& line_weight) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < observations.lines().size(); ++i) {
    if (line_weight.empty() || line_weight[i] > 0.0) count += observations.lines()[i].measured / 2;
  }
  return count;
}

/// The joint of the scene's set that is nearest to an estimate on the way, in the metric of its information where there is some.
std::vector<double> joint_within(const AdmissibleSet& set, const std::vector<double>& theta, const Eigen::MatrixXd& information) {
  const Eigen::VectorXd from = Eigen::Map<const Eigen::VectorXd>(theta.data(), at(theta.size()));
  const auto n = at(theta.size());
  const bool informed =
      information.rows() >= n && information.topLeftCorner(n, n).allFinite() && information.diagonal().head(n).minCoeff() > 0.0;
  Eigen::MatrixXd root = from.cwiseAbs().cwiseMax(1e-6 * from.cwiseAbs().maxCoeff()).cwiseMax(1e-300).cwiseInverse().asDiagonal();
  if (informed) root = minimise::root_of(joint_information(information, theta.size()));
  const Eigen::VectorXd nearest = nearest_admissible(set, from, root, 1.0).theta;
  return nearest.allFinite() ? std::vector<double>(nearest.begin(), nearest.end()) : theta;
}

/// Tells Control::so_far the best joint so far: that of the least Σ L, before there is one the last; under the constraints of the
/// scene, as the result will be.
class BestJoint {
 public:
  BestJoint(const Plan& plan, const Solution& begun, const Control& control) : plan_(plan), begun_(begun), control_(control) {}

  void tell(const LikelihoodFit& fit, double loss) {
    ++steps_;
    if (!(loss <= least_)) return;
    least_ = loss;
    Solution best = begun_;
    best.status = Status::not_converged;
    minimise::LinearSolution linear;
    linear.y = {fit.theta.begin(), fit.theta.begin() + std::ptrdiff_t(plan_.columns->size())};
    linear.rank = linear.y.size();
    if (plan_.admissible) linear.y = joint_within(*plan_.admissible, linear.y, fit.information);
    interpret(plan_, linear, best);
    best.fit.lines = plan_.lines.size();
    best.fit.equations_used = equations_used(*likelihood_plan(plan_)->observations, {});
    best.fit.iterations = steps_;
    best.runtime_s.solve = std::max(0.0, seconds_since(begin_) - best.runtime_s.start);
    control_.so_far(best);
  }

 private:
  const Plan& plan_;
  const Solution& begun_;
  const Control& control_;
  Clock::time_point begin_ = Clock::now();
  double least_ = std::numeric_limits<double>::infinity();
  std::size_t steps_ = 0;
};

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

/// The lines that say something of the joint, and how many of them are outlying.
struct UsedLines {
  std::size_t all = 0, outlying = 0;

  bool sets_aside() const { return 3 * outlying <= all; }
};

UsedLines used_lines(const LikelihoodFit& fit) {
  UsedLines out;
  for (const double weight : fit.line_weight) {
    out.all += weight > 0.0;
    out.outlying += weight > 0.0 && weight < 0.5;
  }
  return out;
}

ChiSquare chi_square_of(const Observations& observations, const std::vector<ScaledPrior>& priors, const LikelihoodFit& fit) {
  const UsedLines lines = used_lines(fit);
  ChiSquare out{.outlying_lines = lines.outlying, .by_line = {}};
  for (std::size_t i = 0; i < fit.line_cost.size(); ++i) {
    const double redundancy = observations.lines()[i].redundancy(observations.layout());
    const bool used = fit.line_weight[i] > 0.0;
    out.by_line.push_back(used ? fit.line_cost[i] / redundancy : std::numeric_limits<double>::quiet_NaN());
    if (!used || (lines.sets_aside() && fit.line_weight[i] < 0.5)) continue;
    out.value += fit.line_cost[i];
    out.degrees_of_freedom += redundancy;
  }
  for (const auto& [column, value, weight] : priors) {
    out.value += weight * weight * (value - fit.theta[column]) * (value - fit.theta[column]);
    out.degrees_of_freedom += 1.0;
  }
  out.degrees_of_freedom -= static_cast<double>(fit.theta.size());
  return out;
}

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

bool tied(const Plan& plan) { return plan.admissible && !plan.admissible->ties.empty(); }

/// The information on the unknowns that the ties leave.
Eigen::MatrixXd within_ties(const Plan& plan, const Eigen::MatrixXd& information) {
  const Eigen::MatrixXd& directions = plan.admissible->directions;
  return directions.transpose() * information * directions;
}

/// Of all unknowns. Inequalities are left out of it: they make errors smaller, and the distribution is no longer normal then.
Eigen::MatrixXd covariance_under_ties(const Plan& plan, const Eigen::MatrixXd& information) {
  if (!tied(plan)) return minimise::covariance_of(information);
  const Eigen::MatrixXd& directions = plan.admissible->directions;
  return directions * minimise::covariance_of(within_ties(plan, information)) * directions.transpose();
}

/// The estimates and what of them the information fixes.
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

/// χ² over degrees of freedom of the lines without gross errors: those with at most ten times their expectation.
double fitting_ratio(const ChiSquare& chi_square, const LikelihoodFit& fit) {
  constexpr double gross = 10.0;
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < fit.line_weight.size(); ++i) {
    if (!(fit.line_weight[i] > 0.0 && chi_square.by_line[i] <= gross)) continue;
    sum += chi_square.by_line[i];
    ++count;
  }
  const double freedom = std::max(1.0, chi_square.degrees_of_freedom);
  if (!(2.0 * count > static_cast<double>(fit.line_weight.size()))) return chi_square.value / freedom;
  return sum / count * (freedom + static_cast<double>(fit.theta.size())) / freedom;
}

/// A fit with what is asked of it at once.
struct Fitted {
  LinearisedLikelihood found;
  ChiSquare chi_square;
  double ratio = 1.0;  ///< χ² over degrees of freedom, of the lines that count
  std::optional<TriedErrors> tried = {};
  std::unique_ptr<AssumedGain> gain = {};  ///< a common gain that is one of the unknowns
  std::optional<FileGain> without = {};    ///< what the fit without that gain said of it
  Eigen::VectorXd pull = {};               ///< of the scene's inequalities; empty: none
  LinearisedLikelihood::NearbyGradients nearby = {};  ///< those that trying errors brought

  bool is_own(const Plan& plan) const { return plan.solver == Solver::gauss_helmert && found.fit.converged; }
  /// Whether intervals may hold more than the noise that variances tell.
  bool may_widen(const Plan& plan) const { return is_own(plan) && !plan.admissible && plan.scene.identify.bootstrap == 0; }
};

Fitted with_chi_square(const Plan& plan, LinearisedLikelihood fitted) {
  const LikelihoodPlan& own = *likelihood_plan(plan);
  ChiSquare chi_square = chi_square_of(*own.observations, own.priors, fitted.fit);
  const double ratio = fitting_ratio(chi_square, fitted.fit);
  return {std::move(fitted), std::move(chi_square), ratio};
}

Fitted fitted(const Plan& plan, const Control& control, const std::shared_ptr<std::string>& stage, Solution& out) {
  const Clock::time_point start = Clock::now();
  BestJoint best(plan, out, control);
  FollowOptions options;
  if (control.so_far) options.listener = [&best](const LikelihoodFit& found, double loss) { best.tell(found, loss); };
  if (control.judgement == Judgement::data) {
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

/// Together with the first gradients of godambe_information(), which the same factors of the lines give.
void try_errors_of(const Plan& plan, const Control& control, Fitted& all) {
  if (all.is_own(plan)) all.nearby = all.found.begin_godambe();
  all.tried = try_errors(plan, all.found, all.found.fit, all.ratio, control, all.nearby);
}

/// Whether a gain explains the misfit beyond its expectation, or half of it.
bool explains(double with, double without, double freedom) {
  const auto excess = [&](double ratio) { return ratio - 1.0 - 3.0 * std::sqrt(2.0 / std::max(1.0, freedom)); };
  return excess(with) < 0.5 * std::max(0.0, excess(without));
}

/// Once more with a gain of all FRFs of a file, where the data call for that and it explains them.
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

/// What is in the intervals beside the noise that variances tell.
struct Widened {
  Intervals intervals;
  bool includes_misfit = false;
  double likely = 0.0;
};

/// A stretch of frequencies at three standard deviations or more; nullptr: none is seen.
const FileGain* seen_stretch(const TriedErrors& tried) {
  constexpr double seen = 3.0;
  const FileGain* const stretch = tried.stretch();
  return stretch != nullptr && std::abs(stretch->score) >= seen ? stretch : nullptr;
}

/// χ² of the lines beyond its expectation, each with a weight.
double excess_of(const Plan& plan, const Fitted& all, const std::vector<double>& weights) {
  const Observations& observations = *likelihood_plan(plan)->observations;
  double excess = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const double by_line = all.chi_square.by_line[i];
    if (weights[i] > 0.0 && std::isfinite(by_line))
      excess += weights[i] * (by_line - 1.0) * observations.lines()[i].redundancy(observations.layout());
  }
  return excess;
}

/// A stretch of a file's frequencies that is seen.
struct SeenStretch {
  const FileGain* stretch = nullptr;     ///< as the lines count in the fit; nullptr: none is seen
  FileGain told = {};                    ///< the same where lines that it explains count in full
  Eigen::VectorXd step = {};             ///< of the unknowns by the lines' weights, without the stretch
};

/// A stretch makes lines on resonances outliers, and the fit sets aside what tells most of it. Where it explains half of what is set
/// aside, the lines count in full.
SeenStretch seen_stretch(const Plan& plan, const Fitted& all, const Control& control) {
  const LikelihoodFit& fit = all.found.fit;
  SeenStretch seen{.stretch = seen_stretch(*all.tried)};
  const Eigen::Index known = at(fit.theta.size());
  seen.step = Eigen::VectorXd::Zero(known);
  if (seen.stretch == nullptr) return seen;
  seen.told = *seen.stretch;
  LikelihoodFit whole = fit;
  std::vector<double> aside;
  for (double& weight : whole.line_weight) {
    aside.push_back(weight > 0.0 ? 1.0 - weight : 0.0);
    if (weight > 0.0) weight = 1.0;
  }
  const double set_aside = excess_of(plan, all, aside);
  if (!(set_aside > 0.0)) return seen;
  LinearisedLikelihood::NearbyGradients of_no_use;
  const auto more = try_errors(plan, all.found, whole, all.ratio, control, of_no_use);
  const FileGain* const found = more ? more->stretch() : nullptr;
  if (found == nullptr || found - more->stretches.data() != seen.stretch - all.tried->stretches.data()) return seen;
  const double explained = found->score * found->score - seen.stretch->score * seen.stretch->score;
  if (!(explained * all.tried->inflation * all.tried->inflation > 0.5 * set_aside)) return seen;
  seen.step = minimise::covariance_of(more->scores.information.topLeftCorner(known, known)) * more->scores.gradient.head(known);
  seen.told = *found;
  return seen;
}

/// χ² over degrees of freedom once a stretch is taken off: as much of its excess goes as of the lines as they count.
double ratio_without(const Plan& plan, const Fitted& all, const FileGain* stretch) {
  if (stretch == nullptr) return all.ratio;
  const double excess = excess_of(plan, all, all.found.fit.line_weight), explained = std::pow(stretch->score * all.tried->inflation, 2);
  return explained >= excess ? std::min(all.ratio, 1.0) : 1.0 + (all.ratio - 1.0) * (1.0 - explained / excess);
}

/// Where there is misfit, what a stretch does not explain of it is looked for at one standard deviation, not at five.
constexpr double still_there = 0.2;

Widened widened(const Plan& plan, const Fitted& all, const Eigen::MatrixXd& information, const Control& control, Solution& out) {
  const ChiSquare& chi_square = all.chi_square;
  const std::size_t joint = plan.columns->size();
  Widened to{Intervals(covariance_under_ties(plan, joint_information(information, joint)))};
  to.likely = likely_chi_square(plan, chi_square.degrees_of_freedom, likelihood_plan(plan)->observations->mirror_differences());
  if (!all.tried || !all.may_widen(plan) || minimise::null_space_of(all.found.fit.information).cols() > 0) return to;
  const TriedErrors& tried = *all.tried;
  if (!tried.files.empty() && !tried.is_calibration_stated) to.intervals.add_gain(tried.files.front());
  note_calibration(to.intervals.cost(), all.without, tried, out);
  tell_shared_errors(plan, tried, information, to.intervals, out);
  const SeenStretch seen = seen_stretch(plan, all, control);
  if (seen.stretch != nullptr) tell_stretch(plan, all.found.fit, seen.told, seen.step, to.intervals, out);
  if (!all.without && !tried.is_calibration_stated) tell_unexplained_gain(tried, to.intervals, out);
  const double left = ratio_without(plan, all, seen.stretch);
  to.includes_misfit = all.ratio > to.likely;
  const bool exceeds = to.includes_misfit && left > 1.0 + still_there * (to.likely - 1.0);
  const auto jackknife = tried.jackknife(all.found.fit.theta.size(), seen.stretch);
  const bool scatters = jackknife && jackknife->tells_more() && !tried.shared.are_seen();
  if (jackknife && (exceeds || scatters)) to.intervals.include_misfit(*jackknife, exceeds ? std::sqrt(std::max(1.0, left)) : 1.0);
  const auto sensors = exceeds ? sensor_scatter(plan, all.found, all.found.fit, all.found.fit.information, control) : std::nullopt;
  if (sensors) to.intervals.include_sensors(*sensors);
  if (scatters && !to.includes_misfit) tell_scatter(*jackknife, out);
  to.includes_misfit = to.includes_misfit && (jackknife || sensors || !exceeds);
  return to;
}

/// Standard errors do not hold a bias of H1, and intervals that of the files where it is seen.
void tell_force_noise(Solution& out) {
  const auto found = std::ranges::find(out.suspects, SuspectKind::force_noise, &Suspect::kind);
  if (out.status != Status::ok || found == out.suspects.end()) return;
  tell(out, Status::doubtful, "Noise of the force's signal: " + found->evidence + ". Use H2 or Hv, or a force with less noise.");
}

void estimate(const Plan& plan, const Control& control, Solution& out) {
  const Clock::time_point start = Clock::now();
  Observations& observations = *likelihood_plan(plan)->observations;
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
  out.fit.lines = plan.lines.size();
  out.fit.equations_used = equations_used(observations, fit.line_weight);
  out.fit.iterations = fit.iterations;
  out.fit.chi_square = all.chi_square;
  out.fit.chi_square->likely = widest.likely;
  if (all.tried && all.may_widen(plan))
    out.suspects = fit_suspects(*all.tried, all.without, widest.intervals.covariance(), all.found.fit.theta);
  tell_force_noise(out);
  if (control.so_far) control.so_far(out);
  if (plan.scene.identify.bootstrap > 0 && !fit.hopeless) bootstrap_errors(plan, all.found, fit, control, out);
  out.runtime_s.intervals = seconds_since(solved);
  if (plan.scene.identify.starts > 0) out.search = search_of(plan, fit);
  const bool finite = std::ranges::all_of(fit.theta, [](double value) { return std::isfinite(value); });
  if ((!fit.converged && !fit.hopeless) || !finite) {
    out.status = Status::not_converged;
    out.message = finite ? "The likelihood did not converge."
                         : "The likelihood broke down: is a line on a resonance without any damping? Leave such lines out.";
  }
  out.used.accumulator_bytes = observations.bytes() + fit.bytes;
  if (tied(plan))
    out.fit.chi_square->degrees_of_freedom +=
        static_cast<double>(fit.theta.size()) - static_cast<double>(plan.admissible->directions.cols());
  if (plan.admissible) tell_outcome(plan, out);
  if (control.so_far) control.so_far(out);
  const Eigen::MatrixXd covariance = widest.intervals.covariance();
  if (control.detail == Detail::full) {
    stop_if(control.interrupted);
    if (control.progress) control.progress("identifiability", 0, 0);
    const Stopwatch watch(out.runtime_s.identifiability);
    out.identifiability = identifiability_of(plan, all.found, covariance, widest.likely, out);
    tell_calibration(plan, information, out);
    if (all.tried) tell_gains(suspect_gains(*all.tried, all.found.fit.theta.size()), out);
  }
  if (control.judgement == Judgement::none) return;
  const Stopwatch watch(out.runtime_s.check);
  if (all.without) tell_common_gain(*all.without, out);
  judge_likelihood(plan,
                   {.theta = fit.theta,
                    .covariance = covariance,
                    .hopeless = fit.hopeless,
                    .several_minima = !joint_is_reached(plan),
                    .likely = widest.likely,
                    .ratio = all.ratio,
                    .includes_misfit = widest.includes_misfit},
                   control, out);
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
  if (goes_by_parts(plan)) return plan_by_parts(plan, plan_start);
  PlannedMethod whole = plan_observations(plan, plan_start, std::make_unique<LikelihoodMethod>());
  return is_better_by_parts(plan, whole.cost) ? plan_by_parts(plan, plan_start) : std::move(whole);
}

}  // namespace jointid::ident
