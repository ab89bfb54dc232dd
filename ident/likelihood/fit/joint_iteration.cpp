#include "ident/likelihood/fit/joint_iteration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/eigen.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

/// The part of a step that changes no unknown by more than half of itself, or of what it was at the start, where that is more:
/// an unknown that changes its sign passes zero.
double half_of(const Eigen::VectorXd& step, const std::vector<double>& theta, const std::vector<double>& start) {
  double scale = 1.0;
  for (std::size_t i = 0; i < theta.size(); ++i) {
    const double size = std::max(std::abs(theta[i]), std::abs(start[i]));
    if (size != 0.0 && step[at(i)] != 0.0) scale = std::min(scale, 0.5 * size / std::abs(step[at(i)]));
  }
  return scale;
}

/// Information of lines from where they stood stays while the joint moves less than this, in standard deviations; not at the end.
constexpr double kept_while_rough = 1.0, kept = 0.1;
constexpr double rough = 0.1;  // while weights may still change; FRFs need not be optimised to the end then
constexpr double shrinks_well = 0.2;  // of one step to the last: then what they are made of may be of another place
constexpr double near_enough = 0.3;   // standard deviations: of that a full step with all lines at their minimum leaves a hundredth
constexpr double next_to_none = 1e-6;  // standard deviations
constexpr double least_ratio = 0.1;  // of one step to the last: where an earlier one told it
constexpr std::size_t most_iterations = 60;

/// A step that raises Σ L by more than rounding does is shortened, so often; three in a row of which a hundredth was left crawl.
constexpr double shortened = 0.25, by_rounding = 1e-9, crawl = 0.01;
constexpr int most_attempts = 8, most_crawling = 3;

/// With most lines further than six times their errors off, a joint that does not get 2 % nearer in four steps is not waited for: the
/// data are wrong, or the joint's model.
constexpr double lost_misfit = 36.0, mended = 0.02;
constexpr std::size_t patience = 4;
/// The same where the data contradict every joint.
constexpr double mended_beyond = 0.3;
constexpr std::size_t patience_beyond = 1;

/// How far it is still after a step of that size, when steps shrink by that ratio; as far as the step where they do not shrink.
double left_after(double size, double ratio) { return ratio < 0.5 ? size * ratio / (1.0 - ratio) : size; }

Eigen::VectorXd difference(const std::vector<double>& to, const std::vector<double>& from) {
  Eigen::VectorXd out(at(to.size()));
  for (std::size_t i = 0; i < to.size(); ++i) out[at(i)] = to[i] - from[i];
  return out;
}

/// Within a standard deviation of where another start ended: two such ends count as one (search_of()).
bool is_at(const LikelihoodFit& end, const std::vector<double>& theta, double tolerance) {
  return norm_of(difference(theta, end.theta), end.information) < std::sqrt(tolerance);
}

std::vector<double> added(std::vector<double> theta, const Eigen::VectorXd& step, double scale) {
  for (std::size_t i = 0; i < theta.size(); ++i) theta[i] += scale * step[at(i)];
  return theta;
}

}  // namespace

double norm_of(const Eigen::VectorXd& step, const Eigen::MatrixXd& information) {
  return std::sqrt(std::max(0.0, step.dot(information * step)));
}

void JointIteration::tell(const LikelihoodFit& fit, double loss) const {
  if (listener_) listener_(fit, loss);
}

void JointIteration::tell(const LikelihoodFit& fit) const { tell(fit, std::numeric_limits<double>::infinity()); }

LikelihoodFit JointIteration::begin(std::vector<double> start, bool linearised) {
  LikelihoodFit fit;
  fit.theta = std::move(start);
  fit.theta.resize(all_.unknowns, 0.0);
  memory_ = {};
  tell(fit);
  is_linearised_ = linearised;
  if (!is_linearised_) all_.lines.begin(fit.theta);
  return fit;
}

/// The step of the joint from the lines as they are linearised where they stand, weighted by their own χ².
Eigen::VectorXd JointIteration::whitened_step(const std::vector<double>& theta, Eigen::MatrixXd& information) {
  if (!std::exchange(is_linearised_, false)) all_.lines.linearise(theta);
  all_.lines.take_linearised_costs();
  all_.lines.choose_tolerance();
  all_.lines.weigh_robustly();
  Eigen::VectorXd gradient;
  all_.sum(theta, information, gradient);
  return minimise::determined_step(information, gradient);
}

bool JointIteration::whiten(LikelihoodFit& fit, std::size_t most, double tolerance, bool moves_frfs) {
  for (std::size_t iteration = 0; iteration < most; ++iteration) {
    watch_(++fit.iterations);
    const Eigen::VectorXd step = whitened_step(fit.theta, fit.information);
    const std::vector<double> before = std::exchange(fit.theta, added(fit.theta, step, 1.0));
    tell(fit);
    if (!(norm_of(step, fit.information) < tolerance)) continue;
    if (moves_frfs) all_.lines.advance(before, fit.theta, step);
    return true;
  }
  return false;
}

void JointIteration::correct(LikelihoodFit& fit) {
  const bool poor = all_.lines.layout().asm_jn.empty();  // without H_jn of the assembly the start may be far off
  const std::size_t most = poor ? 30 : 15;
  const double near = poor ? 6.0 : 1.0;  // in standard deviations: close enough for the last stage
  const std::vector<double> start = fit.theta;
  Eigen::MatrixXd information;
  for (std::size_t iteration = 0; iteration < most; ++iteration) {
    watch_(++fit.iterations);
    const Eigen::VectorXd step = whitened_step(fit.theta, information);
    const double scale = poor ? half_of(step, fit.theta, start) : 1.0;
    const std::vector<double> next = added(fit.theta, step, scale);
    all_.lines.advance(fit.theta, next, scale * step);
    fit.theta = next;
    tell(fit);
    if (std::sqrt(step.dot(information * step)) < near) break;
  }
}

/// The step to the minimum of the quadratic model, over the admissible joints where there are constraints.
Eigen::VectorXd JointIteration::joint_step(const std::vector<double>& theta, const Eigen::MatrixXd& information,
                                           const Eigen::VectorXd& gradient, Constraint* within) {
  if (within == nullptr) return memory_.secants.step(information, gradient);
  const Eigen::VectorXd step = minimise::determined_step(information, gradient);
  const Eigen::VectorXd from = Eigen::Map<const Eigen::VectorXd>(theta.data(), at(theta.size()));
  within->nearest = nearest_admissible(within->set, from + step, minimise::root_of(information), std::sqrt(all_.lines.tolerance()));
  return within->nearest.theta - from;
}

/// Without H_jn of the assembly the problem is far from linear: the way is safer along optimised FRFs.
Relaxation JointIteration::relaxation(double tolerance) const {
  return tolerance < rough || all_.lines.layout().asm_jn.empty() ? Relaxation::end : Relaxation::beginning;
}

/// Lines linearised on their constraint; their gradients alone where the joint has hardly moved since, or steps get there all the same.
void JointIteration::linearise(const std::vector<double>& theta, double tolerance, bool shrinks) {
  if (moved_ > (tolerance < rough ? kept : kept_while_rough) && !(is_near_ && shrinks)) {
    all_.lines.linearise(theta);
    moved_ = 0.0;
  } else {
    all_.lines.take_gradients(theta);
  }
}

/// Along a step, shortened until Σ L falls; how much of it was taken. Nothing where no attempt helped: the lines are where they were.
std::optional<double> JointIteration::descend(LikelihoodFit& fit, const Eigen::VectorXd& step, Relaxation until, double& loss) {
  const std::vector<FittedLine> before = all_.lines.snapshot();
  double scale = 1.0;
  for (int attempt = 0; attempt < most_attempts; ++attempt, scale *= shortened) {
    const std::vector<double> next = added(fit.theta, step, scale);
    all_.lines.follow(before, next, scale * step, until);
    const double reached = all_.total(next);
    if (!(reached <= loss * (1.0 + by_rounding))) continue;
    loss = reached;
    fit.theta = next;
    tell(fit, loss);
    return scale;
  }
  all_.lines.restore(before);
  return std::nullopt;
}

/// Whether the last steps did not mend lines that are far from fitting.
bool JointIteration::is_hopeless(const std::vector<double>& theta, const std::vector<double>& losses) {
  if (!(all_.lines.tolerance() > lost_misfit)) return false;
  const bool beyond = opinion_.is_beyond_any_joint(all_, theta);
  const std::size_t steps = beyond ? patience_beyond : patience;
  return losses.size() > steps && losses.back() > (1.0 - (beyond ? mended_beyond : mended)) * losses[losses.size() - 1 - steps];
}

bool JointIteration::project(LikelihoodFit& fit, double tolerance, From from, const LikelihoodFit* known, Constraint* within) {
  const Relaxation until = relaxation(tolerance);
  if (from == From::last_project) {
    all_.lines.take_gradients(fit.theta);
  } else {
    from == From::measured ? all_.lines.settle_measured(fit.theta) : all_.lines.settle(fit.theta, until);
    moved_ = 0.0;
  }
  if (within == nullptr) all_.lines.choose_tolerance();
  all_.lines.weigh_robustly();
  bool is_linearised = true;
  double last = 0.0, ratio = memory_.shrinks;
  bool shrinks = true;
  int crawling = 0;  // steps in a row of which next to nothing helped
  std::vector<double> losses = {all_.total(fit.theta)};
  Eigen::VectorXd gradient, taken;
  while (fit.iterations < most_iterations) {
    watch_(++fit.iterations);
    if (!std::exchange(is_linearised, false)) linearise(fit.theta, tolerance, shrinks);
    const Eigen::VectorXd before_taken = std::exchange(gradient, {});
    all_.sum(fit.theta, fit.information, gradient);
    if (taken.size() > 0) memory_.secants.note(taken, before_taken - gradient, fit.information);
    const Eigen::VectorXd step = joint_step(fit.theta, fit.information, gradient, within);
    const double size = norm_of(step, fit.information) / std::sqrt(all_.lines.tolerance());
    double loss = losses.back();
    const std::optional<double> scale = descend(fit, step, until, loss);
    if (!scale) return size < tolerance;
    if (known && *scale == 1.0 && size < 1.0 && is_at(*known, fit.theta, all_.lines.tolerance())) {
      fit.reached_known = true;
      return true;
    }
    taken = *scale * step;
    moved_ += *scale * size;
    all_.lines.weigh_robustly();
    crawling = *scale < crawl ? crawling + 1 : 0;
    if (crawling == most_crawling) return false;
    losses.push_back(loss);
    if (is_hopeless(fit.theta, losses)) {
      fit.hopeless = true;
      return false;
    }
    if (last > 0.0) {
      memory_.shrinks = ratio = size / last;
      shrinks = ratio < shrinks_well;
    }
    if (left_after(size, std::max(ratio, least_ratio)) < all_.misfit_of(loss) * tolerance) {
      if (tolerance < rough) finish_exactly(fit, until, within);
      if (tolerance < rough && is_near_) polish(fit, until, within);
      return true;
    }
    last = size;
  }
  return false;
}

/// A full step with all lines at their minimum and linearised there: steps before may have had information and FRFs that were
/// near, which leaves errors of first order in how near. More of them without noise, where a step takes most of the misfit off, and where
/// steps by information of measured FRFs did not come near.
void JointIteration::finish_exactly(LikelihoodFit& fit, Relaxation until, Constraint* within) {
  constexpr int most = 4;
  constexpr double most_of_it = 0.1;
  for (int k = 0; k < most; ++k) {
    all_.lines.settle(fit.theta, Relaxation::end);
    Eigen::VectorXd gradient;
    all_.sum(fit.theta, fit.information, gradient);
    const double loss = all_.total(fit.theta);
    const Eigen::VectorXd step = joint_step(fit.theta, fit.information, gradient, within);
    const bool is_near = !is_near_ || norm_of(step, fit.information) < near_enough * std::sqrt(all_.lines.tolerance());
    const std::vector<FittedLine> before = all_.lines.snapshot();
    const std::vector<double> next = added(fit.theta, step, 1.0);
    all_.lines.follow(before, next, step, until);
    const double next_loss = all_.total(next);
    if (!(next_loss <= loss * (1.0 + by_rounding))) {
      all_.lines.restore(before);
      return;
    }
    fit.theta = next;
    if (is_near && !(next_loss < most_of_it * loss)) return;
  }
}

/// What finish_exactly() leaves, by gradients with its information.
void JointIteration::polish(LikelihoodFit& fit, Relaxation until, Constraint* within) {
  constexpr int most = 3;
  double loss = all_.total(fit.theta);
  for (int k = 0; k < most; ++k) {
    all_.lines.take_gradients(fit.theta);
    Eigen::VectorXd gradient;
    all_.sum(fit.theta, fit.information, gradient);
    const Eigen::VectorXd step = joint_step(fit.theta, fit.information, gradient, within);
    if (norm_of(step, fit.information) < next_to_none * std::sqrt(all_.lines.tolerance()) || !descend(fit, step, until, loss)) return;
  }
}

/// All before FRFs are held on their constraint.
void JointIteration::begin_stages(LikelihoodFit& fit) {
  const double usual =
      std::sqrt(static_cast<double>(all_.unknowns));  // how far an estimate is from the truth, in standard deviations
  if (all_.lines.layout().asm_jn.empty() || !whiten(fit, 4, usual, true)) correct(fit);
}

bool JointIteration::approach(LikelihoodFit& fit) {
  begin_stages(fit);
  return project(fit, rough) && minimise::null_space_of(fit.information).cols() == 0;
}

void JointIteration::run(LikelihoodFit& fit, const LikelihoodFit* known) {
  begin_stages(fit);
  if (all_.lines.variances_by_law()) {
    all_.lines.arrive(fit.theta);
    all_.lines.take_variances_here(fit.theta);
  }
  finish(fit, known);
}

void JointIteration::run_near(LikelihoodFit& fit, const LikelihoodFit* known) {
  is_near_ = true;
  finish(fit, known);
}

void JointIteration::finish(LikelihoodFit& fit, const LikelihoodFit* known) {
  fit.converged = project(fit, rough, is_near_ ? From::measured : From::anywhere, known);
  if (fit.reached_known) return;
  const auto improves = [&](double before) { return all_.lines.tolerance() > 1.0 && all_.lines.tolerance() < 0.9 * before; };
  for (double before = 2.0 * all_.lines.tolerance(); fit.converged && improves(before);) {
    before = all_.lines.tolerance();  // lines that fit better now may tell others as outlying
    fit.converged = project(fit, rough, From::anywhere, known);
  }
  while (fit.converged && all_.lines.variances_by_law() && fit.iterations < most_iterations) {
    const std::vector<double> before = fit.theta;
    all_.lines.take_variances_here(fit.theta);
    fit.converged = project(fit, rough, From::last_project, known);
    if (norm_of(difference(fit.theta, before), fit.information) < 10.0 * settled * std::sqrt(all_.lines.tolerance())) break;
  }
  const bool stay = all_.lines.layout().is_large();  // lines are optimised and factored once more in the end
  if (fit.converged) fit.converged = project(fit, settled, stay ? From::last_project : From::anywhere, known);
  if (!fit.converged && all_.are_far_from_fitting()) fit.hopeless = true;
  all_.finish(fit);
}

}  // namespace jointid::ident
