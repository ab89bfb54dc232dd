#include "ident/likelihood/fit/estimator.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "ident/likelihood/data/many_lines.hpp"
#include "ident/likelihood/fit/joint_iteration.hpp"

namespace jointid::ident {
namespace {

/// When starts far from fitting end within a tenth of each other no other is tried: the data are wrong, or the joint's model.
constexpr double same_end = 0.1;

/// How many of the ends of starts that are far from fitting are about as far as this one.
std::ptrdiff_t times_as_far(double loss, const std::vector<double>& far) {
  return std::ranges::count_if(far, [loss](double other) { return std::abs(other - loss) <= same_end * loss; });
}

std::ptrdiff_t times_reached(double loss, const std::vector<LikelihoodFit::End>& ends) {
  return std::ranges::count_if(ends, [loss](const LikelihoodFit::End& end) { return end.loss <= loss + 1e-3 * std::max(1.0, loss); });
}

/// Which starts were followed to which ends.
struct Ends {
  LikelihoodFit best;
  std::vector<FittedLine> lines;           ///< of the best; empty: where the lines are
  std::vector<LikelihoodFit::End> settled;
  std::vector<double> far;                 ///< losses of ends far from fitting
  bool explains = false, explains_well = false;  ///< by χ², as if the best had settled
  bool is_last = false;                    ///< the best is the one followed last

  bool fits() const { return explains && best.converged; }

  /// One that did not settle, perhaps with variances of another place, was only on its way to one that did and is as good.
  bool is_better(const LikelihoodFit& fit, std::size_t unknowns) const {
    const bool settles = fit.converged && !best.converged && fit.loss < best.loss + static_cast<double>(unknowns);
    return settles || (fit.loss < best.loss - 1e-3 && fit.converged >= best.converged);
  }

  void add(LikelihoodFit fit, std::size_t k, const PenalisedLines& all) {
    constexpr double at_95_percent = 1.645;  // standard deviations, on one side
    if (fit.converged) settled.push_back({fit.loss, fit.theta});
    const double end_loss = fit.loss;
    is_last = k == 0 || is_better(fit, all.unknowns);
    if (is_last) {
      best = std::move(fit);
      explains = all.lines.fit(all.unknowns);
      explains_well = all.lines.fit(all.unknowns, at_95_percent);
      lines.clear();
    }
    best.starts = k + 1;
    if (all.are_far_from_fitting()) far.push_back(end_loss);
  }

  /// Before the lines move from the best.
  void keep(const PenalisedLines& all) {
    if (lines.empty()) lines = all.lines.snapshot();
  }

  bool is_enough(const FollowOptions& options) const {
    if (options.follow == Follow::all || !fits()) return false;
    if (options.follow == Follow::until_reached_twice) return explains_well && times_reached(best.loss, settled) > 1;
    return !(options.doubtful && options.doubtful(best));
  }
};

}  // namespace

LikelihoodEstimator::LikelihoodEstimator(LikelihoodData& observations, const restrictions::Restriction& restriction,
                                         const UnknownColumns& columns, double omega0, EstimatorOptions options)
    : all_{.lines = FittedLines(observations, restriction, columns, omega0, options.threads),
           .priors = std::move(options.priors),
           .unknowns = columns.size() + observations.systematic().size(),
           .joint_unknowns = columns.size()} {
  all_.lines.set_watch(std::move(options.line_watch));
}

bool LikelihoodEstimator::takes_linearised(const std::vector<double>& start) {
  std::vector<double> theta = start;
  theta.resize(all_.unknowns, 0.0);
  return std::exchange(linearised_at_, std::nullopt) == theta;
}

/// Where an eighth of many large lines gets to from a start; empty where that tells less than all of them would.
std::optional<LikelihoodFit> LikelihoodEstimator::approached(const std::vector<double>& start, const FitWatcher& watch) {
  constexpr std::size_t every = 8;
  const FittedLines& lines = all_.lines;
  const bool is_long = lines.layout().is_large() && lines.are_own() && lines.used() >= many_lines;
  if (!is_long || lines.layout().asm_jn.empty() || lines.variances_by_law()) return std::nullopt;
  PenalisedLines some{lines.spread(every), all_.priors, all_.unknowns, all_.joint_unknowns};
  StepMemory memory;
  SecondOpinion opinion;
  const FitListener nobody;
  JointIteration iteration(some, memory, opinion, watch, nobody);
  LikelihoodFit fit = iteration.begin(start, false);
  return iteration.approach(fit) ? std::optional(std::move(fit)) : std::nullopt;
}

LikelihoodFit LikelihoodEstimator::run_from(std::vector<double> start, JointIteration iteration, const LikelihoodFit* known,
                                            const FitWatcher& watch) {
  all_.lines.take_variances_as_measured();
  const bool linearised = takes_linearised(start);
  const auto near = linearised ? std::nullopt : approached(start, watch);
  if (near) start = near->theta;
  LikelihoodFit fit = iteration.begin(std::move(start), linearised);
  if (near) {
    fit.iterations = near->iterations;
    iteration.run_near(fit, known);
  } else {
    iteration.run(fit, known);
  }
  return fit;
}

LinearisedLikelihood LikelihoodEstimator::run(const Starts& starts, const FitWatcher& watch, FollowOptions options) && {
  StepMemory memory;
  SecondOpinion opinion(options.second_opinion);
  const JointIteration fresh(all_, memory, opinion, watch, options.listener);
  const std::ptrdiff_t enough = all_.lines.layout().asm_jn.empty() ? 4 : 2;
  Ends ends;
  for (std::size_t k = 0;; ++k) {
    const auto start = starts(k);
    if (!start) break;
    const bool is_known = options.follow == Follow::until_reached_twice && ends.fits();
    LikelihoodFit fit = run_from(*start, fresh, is_known ? &ends.best : nullptr, watch);
    if (fit.reached_known) std::tie(fit.loss, fit.theta) = std::tie(ends.best.loss, ends.best.theta);
    ends.add(std::move(fit), k, all_);
    if (options.follow != Follow::all && !ends.fits() &&
        (times_as_far(ends.best.loss, ends.far) >= enough || opinion.is_beyond_any_joint(all_, ends.best.theta))) {
      ends.best.hopeless = true;
      if (options.gives_up) break;
    }
    if (ends.is_enough(options)) break;
    ends.keep(all_);
  }
  if (ends.explains && !ends.best.converged) {  // ran out of iterations
    ends.keep(all_);
    LikelihoodFit fit = run_from(ends.best.theta, fresh, nullptr, watch);
    ends.is_last = fit.converged;
    if (ends.is_last) {
      ends.settled.push_back({fit.loss, fit.theta});
      fit.starts = ends.best.starts;
      fit.iterations += ends.best.iterations;
      ends.best = std::move(fit);
      ends.lines.clear();
    }
  }
  ends.best.ends = std::move(ends.settled);
  if (!ends.lines.empty()) all_.lines.restore(std::move(ends.lines));
  if (!ends.is_last) all_.lines.take_variances_here(ends.best.theta);  // the start after it took its own
  return {std::move(all_), std::move(ends.best), std::move(memory), std::move(opinion)};
}

LinearisedLikelihood LikelihoodEstimator::refine(std::vector<double> start, const FitWatcher& watch) && {
  constexpr double near = 1e-2;  // standard deviations: replicates differ by one
  StepMemory memory;
  SecondOpinion opinion;
  const FitListener nobody;
  JointIteration iteration(all_, memory, opinion, watch, nobody);
  const bool linearised = takes_linearised(start);
  LikelihoodFit fit = iteration.begin(std::move(start), linearised);
  fit.converged = iteration.project(fit, near);
  all_.finish(fit);
  return {std::move(all_), std::move(fit), std::move(memory), std::move(opinion)};
}

LinearisedLikelihood LikelihoodEstimator::run_whitened(std::vector<double> start, const FitWatcher& watch,
                                                       FollowOptions options) && {
  constexpr std::size_t most = 50;
  StepMemory memory;
  SecondOpinion opinion(std::move(options.second_opinion));
  JointIteration iteration(all_, memory, opinion, watch, options.listener);
  all_.lines.take_variances_as_measured();
  const bool linearised = takes_linearised(start);
  LikelihoodFit fit = iteration.begin(std::move(start), linearised);
  fit.converged = iteration.whiten(fit, most, settled, false);
  all_.finish(fit);
  return {std::move(all_), std::move(fit), std::move(memory), std::move(opinion)};
}

double LikelihoodEstimator::misfit_at(std::vector<double> theta) {
  constexpr std::size_t some = 10, some_of_poor = 40;  // lines tell starts apart
  theta.resize(all_.unknowns, 0.0);
  FittedLines& lines = all_.lines;
  lines.take_variances_as_measured();
  const bool poor = lines.layout().asm_jn.empty(), some_alone = lines.look_at_some(poor ? some_of_poor : some);
  lines.begin(theta);
  if (!some_alone && (lines.layout().is_large() || !poor)) {  // the fit mostly begins at the first start that is looked at
    lines.linearise(theta);
    linearised_at_ = std::move(theta);
  } else {
    lines.linearise_frfs(theta);
  }
  const double misfit = lines.linearised_misfit();
  lines.look_at_all();
  return misfit;
}

LinearisedLikelihood LikelihoodEstimator::at(std::vector<double> theta) && {
  LikelihoodFit fit;
  fit.theta = std::move(theta);
  fit.theta.resize(all_.unknowns, 0.0);
  fit.information = linearise_at(fit.theta, all_);
  return {std::move(all_), std::move(fit)};
}

}  // namespace jointid::ident
