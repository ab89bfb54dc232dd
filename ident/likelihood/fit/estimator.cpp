#include "ident/likelihood/fit/estimator.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/eigen.hpp"
#include "ident/likelihood/fit/godambe_information.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

/// How long a step is in standard deviations.
double norm_of(const Eigen::VectorXd& step, const Eigen::MatrixXd& information) {
  return std::sqrt(std::max(0.0, step.dot(information * step)));
}

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

/// Fit of the joint's unknowns ends when less than this is left, in standard deviations: those that the misfit makes, which may be
/// more than was assumed, or less, down to this part of it (FRFs without noise).
constexpr double settled = 1e-3;
/// Information of lines from where they stood stays while the joint moves less than this, in standard deviations; not at the end.
constexpr double kept_while_rough = 1.0, kept = 0.1;
constexpr double rough = 0.1;  // while weights may still change; FRFs need not be optimised to the end then
constexpr double least_misfit = 1e-6;
constexpr double least_ratio = 0.1;  // of one step to the last: where an earlier one told it
constexpr std::size_t most_iterations = 60;

/// With most lines further than three times their errors off, when starts end within a tenth of each other no other is tried: the data
/// are wrong, or the joint's model. Further than six times, a joint that does not get 2 % nearer in four steps is not waited for.
constexpr double far_misfit = 9.0, same_end = 0.1;
constexpr double lost_misfit = 36.0, mended = 0.02;
constexpr std::size_t patience = 4;
/// The same where the data contradict every joint.
constexpr double mended_beyond = 0.3;
constexpr std::size_t patience_beyond = 1;

/// How far it is still after a step of that size, when steps shrink by that ratio; as far as the step where they do not shrink.
double left_after(double size, double ratio) { return ratio < 0.5 ? size * ratio / (1.0 - ratio) : size; }

/// Shares a cost out: to the ties what they have of it in the quadratic model, the rest by how far each condition pulled the
/// estimate the way it went.
void share_out(const Eigen::VectorXd& free, double cost, double tie_share, AdmissibleFit& fit) {
  std::vector<double> pulls;
  double sum = 0.0;
  for (const Eigen::VectorXd& force : fit.forces) {
    pulls.push_back(force.size() > 0 ? force.dot(fit.theta - free) : 0.0);
    sum += pulls.back();
  }
  fit.cost = cost;
  fit.tie_cost = sum > 0.0 ? tie_share * cost : (tie_share > 0.0 ? cost : 0.0);
  for (std::size_t k = 0; k < pulls.size(); ++k) fit.shares[k] = sum > 0.0 ? (cost - fit.tie_cost) * pulls[k] / sum : 0.0;
}

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

LikelihoodEstimator::LikelihoodEstimator(LikelihoodData& observations, const restrictions::Restriction& restriction,
                                         const UnknownColumns& columns, double omega0, std::size_t threads)
    : unknowns_(columns.size() + observations.systematic().size()),
      joint_unknowns_(columns.size()),
      lines_(observations, restriction, columns, omega0, threads) {}

double LikelihoodEstimator::total(const std::vector<double>& theta) const {
  double sum = lines_.loss();
  for (const auto& [column, value, weight] : priors_) sum += weight * weight * (value - theta[column]) * (value - theta[column]);
  return sum;
}

double LikelihoodEstimator::misfit_of(double loss) const {
  const double expected = lines_.expected() - static_cast<double>(unknowns_);
  return expected > 0.0 ? std::clamp(std::sqrt(loss / expected), least_misfit, 1.0) : 1.0;
}

void LikelihoodEstimator::sum(const std::vector<double>& theta, Eigen::MatrixXd& information, Eigen::VectorXd& gradient) const {
  information = Eigen::MatrixXd::Zero(at(unknowns_), at(unknowns_));
  gradient = Eigen::VectorXd::Zero(at(unknowns_));
  for (const auto& [column, value, weight] : priors_) {
    information(at(column), at(column)) += weight * weight;
    gradient[at(column)] += weight * weight * (value - theta[column]);
  }
  lines_.add_to(information, gradient);
}

/// The step of the joint from the lines as they are linearised where they stand, weighted by their own χ².
Eigen::VectorXd LikelihoodEstimator::whitened_step(const std::vector<double>& theta, Eigen::MatrixXd& information) {
  if (!std::exchange(is_linearised_, false)) lines_.linearise(theta);
  lines_.take_linearised_costs();
  lines_.choose_tolerance();
  lines_.weigh_robustly();
  Eigen::VectorXd gradient;
  sum(theta, information, gradient);
  return minimise::determined_step(information, gradient);
}

/// Iterative quadratic maximum likelihood: the conditions at the measured FRFs, which are linear in the joint, whitened by the
/// covariance that the last joint gives them. `moves_frfs`: with the last step, where that is below the tolerance, all FRFs take theirs:
/// it is one of the implicit iteration, too.
bool LikelihoodEstimator::whitened_stage(LikelihoodFit& fit, std::size_t most, double tolerance, bool moves_frfs,
                                         const FitWatcher& watch) {
  for (std::size_t iteration = 0; iteration < most; ++iteration) {
    watch(++fit.iterations);
    const Eigen::VectorXd step = whitened_step(fit.theta, fit.information);
    const std::vector<double> before = std::exchange(fit.theta, added(fit.theta, step, 1.0));
    tell(fit);
    if (!(norm_of(step, fit.information) < tolerance)) continue;
    if (moves_frfs) lines_.advance(before, fit.theta, step);
    return true;
  }
  return false;
}

void LikelihoodEstimator::implicit_stage(LikelihoodFit& fit, const FitWatcher& watch) {
  const bool poor = lines_.layout().a.empty();  // without H_jn of the assembly the start may be far off
  const std::size_t most = poor ? 30 : 15;
  const double near = poor ? 6.0 : 1.0;  // in standard deviations: close enough for the last stage
  const std::vector<double> start = fit.theta;
  Eigen::MatrixXd information;
  for (std::size_t iteration = 0; iteration < most; ++iteration) {
    watch(++fit.iterations);
    const Eigen::VectorXd step = whitened_step(fit.theta, information);
    const double scale = poor ? half_of(step, fit.theta, start) : 1.0;
    const std::vector<double> next = added(fit.theta, step, scale);
    lines_.advance(fit.theta, next, scale * step);
    fit.theta = next;
    tell(fit);
    if (std::sqrt(step.dot(information * step)) < near) break;
  }
}

/// The step to the minimum of the quadratic model, over the admissible joints where there are constraints.
Eigen::VectorXd LikelihoodEstimator::joint_step(const std::vector<double>& theta, const Eigen::MatrixXd& information,
                                                const Eigen::VectorXd& gradient) {
  if (admissible_ == nullptr) return secants_.step(information, gradient);
  const Eigen::VectorXd step = minimise::determined_step(information, gradient);
  const Eigen::VectorXd from = Eigen::Map<const Eigen::VectorXd>(theta.data(), at(theta.size()));
  nearest_ = nearest_admissible(*admissible_, from + step, minimise::root_of(information), std::sqrt(lines_.tolerance()));
  return nearest_.theta - from;
}

/// Without H_jn of the assembly the problem is far from linear: the way is safer along optimised FRFs.
Relaxation LikelihoodEstimator::relaxation(double tolerance) const {
  return tolerance < rough || lines_.layout().a.empty() ? Relaxation::end : Relaxation::beginning;
}

bool LikelihoodEstimator::far_from_fitting() const { return lines_.tolerance() > far_misfit; }

bool LikelihoodEstimator::beyond_any_joint(const std::vector<double>& theta) {
  if (!second_opinion_ || !far_from_fitting()) return false;
  if (!beyond_any_joint_) beyond_any_joint_ = second_opinion_({theta.begin(), theta.begin() + std::ptrdiff_t(joint_unknowns_)});
  return *beyond_any_joint_;
}

bool LikelihoodEstimator::project(LikelihoodFit& fit, double tolerance, const FitWatcher& watch, From from,
                                  const LikelihoodFit* known) {
  const Relaxation until = relaxation(tolerance);
  if (from == From::anywhere) {
    lines_.settle(fit.theta, until);
    moved_ = 0.0;
  } else {
    lines_.take_gradients(fit.theta);
  }
  if (admissible_ == nullptr) lines_.choose_tolerance();
  lines_.weigh_robustly();
  bool is_linearised = true;
  double loss = total(fit.theta);
  double last = 0.0, ratio = shrinks_;
  int crawling = 0;  // steps in a row of which next to nothing helped
  std::vector<double> losses = {loss};
  Eigen::VectorXd gradient, taken;
  while (fit.iterations < most_iterations) {
    watch(++fit.iterations);
    if (!std::exchange(is_linearised, false)) {
      if (moved_ > (tolerance < rough ? kept : kept_while_rough)) {
        lines_.linearise(fit.theta);
        moved_ = 0.0;
      } else {
        lines_.take_gradients(fit.theta);
      }
    }
    const Eigen::VectorXd before_taken = std::exchange(gradient, {});
    sum(fit.theta, fit.information, gradient);
    if (taken.size() > 0) secants_.note(taken, before_taken - gradient, fit.information);
    const Eigen::VectorXd step = joint_step(fit.theta, fit.information, gradient);
    const double size = norm_of(step, fit.information) / std::sqrt(lines_.tolerance());
    const std::vector<FittedLine> before = lines_.snapshot();
    double scale = 1.0;
    for (int attempt = 0;; ++attempt, scale *= 0.25) {
      if (attempt == 8) {
        lines_.restore(before);
        return size < tolerance;
      }
      const std::vector<double> next = added(fit.theta, step, scale);
      lines_.follow(before, next, scale * step, until);
      const double reached = total(next);
      if (!(reached <= loss * (1.0 + 1e-9))) continue;
      loss = reached;
      fit.theta = next;
      tell(fit, loss);
      break;
    }
    if (known && scale == 1.0 && size < 1.0 && is_at(*known, fit.theta, lines_.tolerance())) {
      fit.reached_known = true;
      return true;
    }
    taken = scale * step;
    moved_ += scale * size;
    lines_.weigh_robustly();
    crawling = scale < 0.01 ? crawling + 1 : 0;
    if (crawling == 3) return false;
    losses.push_back(loss);
    const bool beyond = lines_.tolerance() > lost_misfit && beyond_any_joint(fit.theta);
    const std::size_t steps = beyond ? patience_beyond : patience;
    if (lines_.tolerance() > lost_misfit && losses.size() > steps &&
        loss > (1.0 - (beyond ? mended_beyond : mended)) * losses[losses.size() - 1 - steps]) {
      fit.hopeless = true;
      return false;
    }
    if (last > 0.0) shrinks_ = ratio = size / last;
    if (left_after(size, std::max(ratio, least_ratio)) < misfit_of(loss) * tolerance) {
      if (tolerance < rough) finish_exactly(fit, until);
      return true;
    }
    last = size;
  }
  return false;
}

/// A full step with all lines at their minimum and linearised there: steps before may have had information and FRFs that were
/// near, which leaves errors of first order in how near. Without noise, where a step takes most of the misfit off, more of them.
void LikelihoodEstimator::finish_exactly(LikelihoodFit& fit, Relaxation until) {
  constexpr int most = 4;
  for (int k = 0; k < most; ++k) {
    lines_.settle(fit.theta, Relaxation::end);
    Eigen::VectorXd gradient;
    sum(fit.theta, fit.information, gradient);
    const double loss = total(fit.theta);
    const Eigen::VectorXd step = joint_step(fit.theta, fit.information, gradient);
    const std::vector<FittedLine> before = lines_.snapshot();
    const std::vector<double> next = added(fit.theta, step, 1.0);
    lines_.follow(before, next, step, until);
    const double next_loss = total(next);
    if (!(next_loss <= loss * (1.0 + 1e-9))) {
      lines_.restore(before);
      return;
    }
    fit.theta = next;
    if (!(next_loss < 0.1 * loss)) return;
  }
}

LikelihoodFit LikelihoodEstimator::run_from(std::vector<double> start, const FitWatcher& watch, const LikelihoodFit* known) {
  const double usual =
      std::sqrt(static_cast<double>(unknowns_));  // how far an estimate is from the truth, in standard deviations
  lines_.take_variances_as_measured();
  LikelihoodFit fit = begun(std::move(start));
  if (lines_.layout().a.empty() || !whitened_stage(fit, 4, usual, true, watch)) implicit_stage(fit, watch);
  if (lines_.variances_by_law()) {
    lines_.arrive(fit.theta);
    lines_.take_variances_here(fit.theta);
  }
  fit.converged = project(fit, rough, watch, From::anywhere, known);
  if (fit.reached_known) return fit;
  for (double before = 2.0 * lines_.tolerance(); fit.converged && lines_.tolerance() > 1.0 && lines_.tolerance() < 0.9 * before;) {
    before = lines_.tolerance();  // lines that fit better now may tell others as outlying
    fit.converged = project(fit, rough, watch, From::anywhere, known);
  }
  while (fit.converged && lines_.variances_by_law() && fit.iterations < most_iterations) {
    const std::vector<double> before = fit.theta;
    lines_.take_variances_here(fit.theta);
    fit.converged = project(fit, rough, watch, From::last_project, known);
    if (norm_of(difference(fit.theta, before), fit.information) < 10.0 * settled * std::sqrt(lines_.tolerance())) break;
  }
  const bool stay = lines_.layout().is_large();  // lines are optimised and factored once more in the end
  if (fit.converged) fit.converged = project(fit, settled, watch, stay ? From::last_project : From::anywhere, known);
  if (!fit.converged && far_from_fitting()) fit.hopeless = true;
  finish(fit);
  return fit;
}

LikelihoodFit LikelihoodEstimator::run_whitened(std::vector<double> start, const FitWatcher& watch) {
  lines_.take_variances_as_measured();
  LikelihoodFit fit = begun(std::move(start));
  fit.converged = whitened_stage(fit, 50, 1e-3, false, watch);
  finish(fit);
  return fit;
}

LikelihoodFit LikelihoodEstimator::begun(std::vector<double> start) {
  LikelihoodFit fit;
  fit.theta = std::move(start);
  fit.theta.resize(unknowns_, 0.0);
  secants_.forget();
  shrinks_ = 1.0;
  tell(fit);
  is_linearised_ = std::exchange(linearised_at_, std::nullopt) == fit.theta;
  if (!is_linearised_) lines_.begin(fit.theta);
  return fit;
}

void LikelihoodEstimator::finish(LikelihoodFit& fit) const {
  fit.loss = total(fit.theta);
  for (const FittedLine& line : lines_.snapshot()) {
    fit.line_cost.push_back(line.cost);
    fit.line_weight.push_back(line.weight);
  }
  fit.bytes = lines_.bytes();
}

LikelihoodFit LikelihoodEstimator::refine(std::vector<double> start, const FitWatcher& watch) {
  LikelihoodFit fit = begun(std::move(start));
  fit.converged = project(fit, 1e-2, watch);
  finish(fit);
  return fit;
}

ConstrainedFit LikelihoodEstimator::constrain(LikelihoodFit fit, const AdmissibleSet& set, const FitWatcher& watch) {
  const auto vector = [](const std::vector<double>& theta) {
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(theta.data(), at(theta.size())));
  };
  AdmissibleFit unmoved =
      nearest_admissible(set, vector(fit.theta), minimise::root_of(fit.information), std::sqrt(lines_.tolerance()));
  if (unmoved.theta == vector(fit.theta)) return {std::move(fit), std::move(unmoved)};
  const std::size_t before = std::exchange(fit.iterations, 0);
  fit.converged = project(fit, settled, watch) && fit.converged;  // so that both minima are of the same weights
  const double free_loss = total(fit.theta);
  const Eigen::VectorXd free = vector(fit.theta);
  admissible_ = &set;
  nearest_ = nearest_admissible(set, free, minimise::root_of(fit.information), std::sqrt(lines_.tolerance()));
  const bool moves = nearest_.theta != free;
  const double tie_share = nearest_.cost > 0.0 ? nearest_.tie_cost / nearest_.cost : 0.0;
  if (moves) {
    fit.theta.assign(nearest_.theta.begin(), nearest_.theta.end());
    fit.converged = project(fit, settled, watch) && nearest_.converged;
  }
  admissible_ = nullptr;
  fit.iterations += before;
  fit.line_cost.clear();
  fit.line_weight.clear();
  finish(fit);
  ConstrainedFit out{std::move(fit), std::move(nearest_)};
  out.admissible.theta = vector(out.fit.theta);
  share_out(free, moves ? std::max(0.0, out.fit.loss - free_loss) : 0.0, tie_share, out.admissible);
  return out;
}

namespace {

/// How many of the ends of starts that are far from fitting are about as far as this one.
std::ptrdiff_t times_as_far(double loss, const std::vector<double>& far) {
  return std::ranges::count_if(far, [loss](double other) { return std::abs(other - loss) <= same_end * loss; });
}

std::ptrdiff_t times_reached(double loss, const std::vector<LikelihoodFit::End>& ends) {
  return std::ranges::count_if(ends, [loss](const LikelihoodFit::End& end) { return end.loss <= loss + 1e-3 * std::max(1.0, loss); });
}

}  // namespace

LikelihoodFit LikelihoodEstimator::run(const Starts& starts, const FitWatcher& watch, Follow follow, const Doubt& doubtful) {
  LikelihoodFit best;
  std::vector<LikelihoodFit::End> ends;
  std::vector<FittedLine> lines;  // of the best
  std::vector<double> far;         // losses of ends far from fitting
  beyond_any_joint_.reset();
  constexpr double at_95_percent = 1.645;  // standard deviations, on one side
  const std::ptrdiff_t enough = lines_.layout().a.empty() ? 4 : 2;
  bool explains = false, explains_well = false, is_last = false;  // by χ², as if it had settled
  const auto fits = [&] { return explains && best.converged; };
  for (std::size_t k = 0;; ++k) {
    const auto start = starts(k);
    if (!start) break;
    const bool is_known = follow == Follow::until_reached_twice && fits();
    LikelihoodFit fit = run_from(*start, watch, is_known ? &best : nullptr);
    if (fit.reached_known) std::tie(fit.loss, fit.theta) = std::tie(best.loss, best.theta);
    if (fit.converged) ends.push_back({fit.loss, fit.theta});
    const double end_loss = fit.loss;
    // One that did not settle, perhaps with variances of another place, was only on its way to one that did and is as good.
    const bool settles = fit.converged && !best.converged && fit.loss < best.loss + static_cast<double>(unknowns_);
    is_last = k == 0 || settles || (fit.loss < best.loss - 1e-3 && fit.converged >= best.converged);
    if (is_last) {
      best = std::move(fit);
      explains = lines_.fit(unknowns_);
      explains_well = lines_.fit(unknowns_, at_95_percent);
      lines = lines_.snapshot();
    }
    best.starts = k + 1;
    if (far_from_fitting()) far.push_back(end_loss);
    if (follow != Follow::all && !fits() && (times_as_far(best.loss, far) >= enough || beyond_any_joint(best.theta))) {
      best.hopeless = true;
      break;
    }
    if (follow == Follow::all || !fits()) continue;
    if (follow == Follow::until_reached_twice ? explains_well && times_reached(best.loss, ends) > 1
                                              : !(doubtful && doubtful(best)))
      break;
  }
  if (explains && !best.converged) {  // ran out of iterations
    LikelihoodFit fit = run_from(best.theta, watch, nullptr);
    is_last = fit.converged;
    if (is_last) {
      ends.push_back({fit.loss, fit.theta});
      fit.starts = best.starts;
      fit.iterations += best.iterations;
      best = std::move(fit);
      lines = lines_.snapshot();
    }
  }
  best.ends = std::move(ends);
  lines_.restore(std::move(lines));
  if (!is_last) lines_.take_variances_here(best.theta);  // the start after it took its own
  return best;
}

double LikelihoodEstimator::misfit_at(std::vector<double> theta) {
  constexpr std::size_t some = 10, some_of_poor = 40;  // lines tell starts apart
  theta.resize(unknowns_, 0.0);
  lines_.take_variances_as_measured();
  const bool poor = lines_.layout().a.empty(), some_alone = lines_.look_at_some(poor ? some_of_poor : some);
  lines_.begin(theta);
  if (!some_alone && (lines_.layout().is_large() || !poor)) {  // the fit mostly begins at the first start that is looked at
    lines_.linearise(theta);
    linearised_at_ = std::move(theta);
  } else {
    lines_.linearise_frfs(theta);
  }
  const double misfit = lines_.linearised_misfit();
  lines_.look_at_all();
  return misfit;
}

Eigen::MatrixXd LikelihoodEstimator::information_at(std::vector<double> theta) {
  theta.resize(unknowns_, 0.0);
  linearised_at_.reset();
  lines_.begin(theta);
  lines_.relax(theta);
  lines_.linearise(theta);
  lines_.weigh_alike();
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  sum(theta, information, gradient);
  return information;
}

Eigen::MatrixXd LikelihoodEstimator::godambe_information_at(const LikelihoodFit& fit) {
  const std::vector<FittedLine> there = lines_.snapshot();
  const auto exact = [&](const std::vector<Eigen::VectorXd>& offsets) {
    const Eigen::MatrixXd sums = lines_.gradients_nearby(there, fit.theta, offsets);
    std::vector<Eigen::VectorXd> out;
    for (std::size_t k = 0; k < offsets.size(); ++k) {
      out.emplace_back(sums.col(at(k)));
      for (const auto& [column, value, weight] : priors_) {
        out.back()[at(column)] += weight * weight * (value - fit.theta[column] - offsets[k][at(column)]);
      }
    }
    return out;
  };
  const auto quick = [&](const Eigen::VectorXd& offset) {
    const std::vector<double> theta = added(fit.theta, offset, 1.0);
    lines_.answer(there, theta, offset);
    lines_.take_gradients(theta);
    Eigen::MatrixXd information;
    Eigen::VectorXd gradient;
    sum(theta, information, gradient);
    return gradient;
  };
  const bool saves = lines_.layout().is_large();
  Eigen::MatrixXd curvature = godambe_information(exact, fit.information, saves ? GradientAt(quick) : GradientAt());
  lines_.restore(there);
  return curvature;
}

Eigen::MatrixXd LikelihoodEstimator::information_of(std::size_t line) const {
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(at(unknowns_), at(unknowns_));
  lines_.add_information(line, 1.0, information);
  return information;
}

}  // namespace jointid::ident
