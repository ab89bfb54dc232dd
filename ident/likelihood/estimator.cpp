#include "ident/likelihood/estimator.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ident/eigen_index.hpp"
#include "ident/likelihood/covariance.hpp"
#include "ident/likelihood/guess_y.hpp"
#include "ident/likelihood/line_tolerance.hpp"
#include "ident/likelihood/godambe_information.hpp"

namespace jointid::ident {
namespace {

/// dL/dχ² of the robust loss: 1 for lines that fit, (1.5/ρ)⁴ beyond, ρ² = χ²/redundancy.
double robust_weight(double cost, double redundancy) {
  const double ratio = cost / redundancy;
  return ratio <= outlying ? 1.0 : (outlying / ratio) * (outlying / ratio);
}

/// The loss L itself: χ² up to 1.5² redundancies, then 2·1.5² − 1.5⁴/ρ² of them.
double robust_loss(double cost, double redundancy) {
  const double ratio = cost / redundancy;
  return redundancy * (ratio <= outlying ? ratio : 2.0 * outlying - outlying * outlying / ratio);
}

Eigen::VectorXd pick(const Eigen::VectorXd& all, const std::vector<std::size_t>& which) {
  Eigen::VectorXd out(at(which.size()));
  for (std::size_t i = 0; i < which.size(); ++i) out[at(i)] = all[at(which[i])];
  return out;
}

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
constexpr double least_misfit = 1e-6;
constexpr double least_ratio = 0.1;  // of one step to the last: where an earlier one told it
constexpr std::size_t most_iterations = 60;

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

std::vector<double> added(std::vector<double> theta, const Eigen::VectorXd& step, double scale) {
  for (std::size_t i = 0; i < theta.size(); ++i) theta[i] += scale * step[at(i)];
  return theta;
}

}  // namespace

LikelihoodEstimator::LikelihoodEstimator(LikelihoodData& observations, const restrictions::Restriction& restriction,
                                         const UnknownColumns& columns, double omega0, std::size_t threads)
    : observations_(observations), unknowns_(columns.size()), threads_(threads) {
  for (const LineData& data : observations.lines()) {
    Line line{JointImpedance(restriction, columns, omega0, data.omega), {}, 0.0, 0.0, 1.0, {}};
    if (!line.joint.columns().empty()) line.redundancy = data.redundancy(observations.layout());
    lines_.push_back(std::move(line));
  }
}

void LikelihoodEstimator::for_lines(const std::function<void(std::size_t, LineModel&)>& work) const {
  const auto usable = [&](std::size_t i) { return lines_[i].redundancy > 0.0 && !lines_[i].joint.columns().empty(); };
  if (threads_ == 1) {
    LineModel model(observations_.layout());
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (usable(i)) work(i, model);
    }
    return;
  }
  oneapi::tbb::task_arena arena(threads_ == 0 ? oneapi::tbb::task_arena::automatic : static_cast<int>(threads_));
  arena.execute([&] {
    oneapi::tbb::parallel_for(oneapi::tbb::blocked_range<std::size_t>(0, lines_.size()), [&](const auto& range) {
      LineModel model(observations_.layout());
      for (std::size_t i = range.begin(); i != range.end(); ++i) {
        if (usable(i)) work(i, model);
      }
    });
  });
}

void LikelihoodEstimator::begin(const std::vector<double>& theta) {
  for_lines([&](std::size_t i, LineModel&) { begin_line(i, lines_[i].joint.at(theta)); });
}

/// Measured values where there are, and for the rest what the joint makes of them.
void LikelihoodEstimator::begin_line(std::size_t i, const ComplexMatrix& z) {
  const LineLayout& layout = observations_.layout();
  const LineData& data = observations_.lines()[i];
  LineState& state = lines_[i].state;
  state = measured_start(layout, data);
  guess_y(layout, data, z, state);
  put_on_constraint(layout, z, state);
  for (std::size_t v = 0; v < layout.a.size(); ++v) {
    if (data.a.weight[v] != Complex(0.0)) state.a(at(layout.a[v].row), at(layout.a[v].column)) = data.a.value[v];
  }
  for (std::size_t v = 0; v < layout.b.size(); ++v) {
    if (data.b.weight[v] == Complex(0.0)) continue;
    state.b(at(layout.b[v].row), at(layout.b[v].column)) = data.b.value[v];
    state.b(at(layout.b[v].column), at(layout.b[v].row)) = data.b.value[v];
  }
}

void LikelihoodEstimator::weigh() {
  for (Line& line : lines_) line.weight = line.redundancy > 0.0 ? robust_weight(line.cost / tolerance_, line.redundancy) : 0.0;
}

void LikelihoodEstimator::choose_tolerance() {
  std::vector<double> ratios;
  for (const Line& line : lines_) {
    if (line.redundancy > 0.0) ratios.push_back(line.cost / line.redundancy);
  }
  if (!ratios.empty()) tolerance_ = line_tolerance(std::move(ratios));
}

double LikelihoodEstimator::total(const std::vector<double>& theta) const {
  double sum = 0.0;
  for (const auto& [column, value, weight] : priors_) sum += weight * weight * (value - theta[column]) * (value - theta[column]);
  for (const Line& line : lines_) {
    if (line.redundancy > 0.0) sum += tolerance_ * robust_loss(line.cost / tolerance_, line.redundancy);
  }
  return sum;
}

double LikelihoodEstimator::misfit_of(double loss) const {
  double expected = -static_cast<double>(unknowns_);
  for (const Line& line : lines_) expected += std::max(0.0, line.redundancy);
  return expected > 0.0 ? std::clamp(std::sqrt(loss / expected), least_misfit, 1.0) : 1.0;
}

void LikelihoodEstimator::sum(const std::vector<double>& theta, Eigen::MatrixXd& information, Eigen::VectorXd& gradient) const {
  information = Eigen::MatrixXd::Zero(at(unknowns_), at(unknowns_));
  gradient = Eigen::VectorXd::Zero(at(unknowns_));
  for (const auto& [column, value, weight] : priors_) {
    information(at(column), at(column)) += weight * weight;
    gradient[at(column)] += weight * weight * (value - theta[column]);
  }
  for (const Line& line : lines_) {
    if (line.redundancy <= 0.0) continue;
    const auto& columns = line.joint.columns();
    for (std::size_t i = 0; i < columns.size(); ++i) gradient[at(columns[i])] += line.weight * line.reduced.gradient[at(i)];
    add_information(line, line.weight, information);
  }
}

/// Of a line that cannot be linearised where it stands, such as one on an undamped resonance of the predicted assembly: no
/// information, no step, and the χ² that is expected.
ReducedLine LikelihoodEstimator::says_nothing(const Line& line) const {
  const auto p = at(line.joint.columns().size()), v = at(2 * observations_.layout().variables());
  return {Eigen::MatrixXd::Zero(p, p), Eigen::VectorXd::Zero(p), Eigen::MatrixXd::Zero(v, p), LineStep::Zero(v), line.redundancy};
}

void LikelihoodEstimator::linearise_all(const std::vector<double>& theta) {
  for_lines([&](std::size_t i, LineModel& model) {
    Line& line = lines_[i];
    model.linearise(observations_.lines()[i], line.joint, line.joint.at(theta), line.state, true);
    std::optional<ReducedLine> reduced = model.reduce(0.0);
    for (double damping = 1e-3; !reduced && damping < 1e12; damping *= 10.0) reduced = model.reduce(damping);
    line.reduced = reduced ? std::move(*reduced) : says_nothing(line);
  });
}

/// The step of the joint from the lines as they are linearised where they stand, weighted by their own χ².
Eigen::VectorXd LikelihoodEstimator::whitened_step(const std::vector<double>& theta, Eigen::MatrixXd& information) {
  linearise_all(theta);
  for (Line& line : lines_) line.cost = line.reduced.cost;
  choose_tolerance();
  weigh();
  Eigen::VectorXd gradient;
  sum(theta, information, gradient);
  return determined_step(information, gradient);
}

/// Iterative quadratic maximum likelihood: the conditions at the measured FRFs, which are linear in the joint, whitened by the
/// covariance that the last joint gives them.
bool LikelihoodEstimator::whitened_stage(LikelihoodFit& fit, std::size_t most, double tolerance, const FitWatcher& watch) {
  for (std::size_t iteration = 0; iteration < most; ++iteration) {
    watch(++fit.iterations);
    const Eigen::VectorXd step = whitened_step(fit.theta, fit.information);
    fit.theta = added(fit.theta, step, 1.0);
    if (std::sqrt(step.dot(fit.information * step)) < tolerance) return true;
  }
  return false;
}

void LikelihoodEstimator::implicit_stage(LikelihoodFit& fit, const FitWatcher& watch) {
  const bool poor = observations_.layout().a.empty();  // without H_jn of the assembly the start may be far off
  const std::size_t most = poor ? 30 : 15;
  const double near = poor ? 6.0 : 1.0;  // in standard deviations: close enough for the last stage
  const std::vector<double> start = fit.theta;
  Eigen::MatrixXd information;
  for (std::size_t iteration = 0; iteration < most; ++iteration) {
    watch(++fit.iterations);
    const Eigen::VectorXd step = whitened_step(fit.theta, information);
    const double scale = poor ? half_of(step, fit.theta, start) : 1.0;
    const std::vector<double> next = added(fit.theta, step, scale);
    for_lines([&](std::size_t i, LineModel& model) {
      Line& line = lines_[i];
      const ComplexMatrix z = line.joint.at(fit.theta);
      model.prepare(z, line.state);
      const LineStep own = line.reduced.own - line.reduced.back * (scale * pick(step, line.joint.columns()));
      model.advance(own, line.joint.at(next) - z, line.state);
    });
    fit.theta = next;
    if (std::sqrt(step.dot(information * step)) < near) break;
  }
}

/// Levenberg–Marquardt of one line's FRFs for a given joint.
void LikelihoodEstimator::relax(std::size_t i, LineModel& model, const ComplexMatrix& z) {
  const LineLayout& layout = observations_.layout();
  const LineData& data = observations_.lines()[i];
  Line& line = lines_[i];
  put_on_constraint(layout, z, line.state);
  line.cost = line_cost(layout, data, z, line.state.x, line.state.y);
  double damping = 0.0;
  for (int iteration = 0; iteration < 30; ++iteration) {
    model.linearise(data, line.joint, z, line.state, false);
    double gain = 0.0;
    while (damping < 1e12) {
      if (const auto reduced = model.reduce(damping)) {
        ComplexMatrix x = line.state.x, y = line.state.y;
        move(layout, reduced->own, 1.0, x, y);
        const double cost = line_cost(layout, data, z, x, y);
        if (cost <= line.cost) {
          gain = line.cost - cost;
          line.state.x = std::move(x);
          line.state.y = std::move(y);
          line.cost = cost;
          break;
        }
      }
      damping = std::max(10.0 * damping, 1e-2);
    }
    put_on_constraint(layout, z, line.state);
    damping = damping > 1e-2 ? 0.1 * damping : 0.0;
    if (gain <= 1e-7 * std::max(line.cost, 1.0)) break;
  }
}

/// The implicit iteration of one line for a given joint: from the measured FRFs of both systems to the constraint between them.
void LikelihoodEstimator::approach(std::size_t i, LineModel& model, const ComplexMatrix& z) {
  begin_line(i, z);
  Line& line = lines_[i];
  for (int iteration = 0; iteration < 20; ++iteration) {
    model.linearise(observations_.lines()[i], line.joint, z, line.state, false);
    const auto reduced = model.reduce(0.0);
    if (!reduced) return;
    model.advance(reduced->own, ComplexMatrix::Zero(z.rows(), z.cols()), line.state);
  }
}

void LikelihoodEstimator::relax_all(const std::vector<double>& theta) {
  for_lines([&](std::size_t i, LineModel& model) { relax(i, model, lines_[i].joint.at(theta)); });
  const auto far = std::ranges::count_if(lines_, far_from_fitting);
  // A few lines far from fitting may be stuck: once more from the measured values, and along the implicit iteration. Where
  // there are many it is the joint.
  if (far == 0 || 4 * static_cast<std::size_t>(far) > lines_.size()) return;
  for_lines([&](std::size_t i, LineModel& model) {
    const ComplexMatrix z = lines_[i].joint.at(theta);
    try_again(i, model, z, [&] { take_measured(observations_.layout(), observations_.lines()[i], lines_[i].state); });
    try_again(i, model, z, [&] { approach(i, model, z); });
  });
}

/// Relaxes a line that is far from fitting from another start, and keeps the better of both ends.
void LikelihoodEstimator::try_again(std::size_t i, LineModel& model, const ComplexMatrix& z, const std::function<void()>& start) {
  Line& line = lines_[i];
  if (!far_from_fitting(line)) return;
  const LineState kept = line.state;
  const double cost = line.cost;
  start();
  relax(i, model, z);
  if (line.cost < cost) return;
  line.state = kept;
  line.cost = cost;
}

/// Follows a step of the joint's unknowns with the FRFs of every line, as far as that helps, and optimises them there.
void LikelihoodEstimator::follow(const std::vector<Line>& before, const std::vector<double>& theta, const Eigen::VectorXd& step) {
  const LineLayout& layout = observations_.layout();
  for_lines([&](std::size_t i, LineModel&) {
    Line& line = lines_[i];
    line.state = before[i].state;
    const ComplexMatrix z = line.joint.at(theta);
    ComplexMatrix x = line.state.x, y = line.state.y;
    move(layout, -(before[i].reduced.back * pick(step, line.joint.columns())), 1.0, x, y);
    const LineData& data = observations_.lines()[i];
    if (line_cost(layout, data, z, x, y) > line_cost(layout, data, z, line.state.x, line.state.y)) return;
    line.state.x = std::move(x);
    line.state.y = std::move(y);
  });
  relax_all(theta);
}

/// The step to the minimum of the quadratic model, over the admissible joints where there are constraints.
Eigen::VectorXd LikelihoodEstimator::joint_step(const std::vector<double>& theta, const Eigen::MatrixXd& information,
                                                const Eigen::VectorXd& gradient) {
  if (admissible_ == nullptr) return secants_.step(information, gradient);
  const Eigen::VectorXd step = determined_step(information, gradient);
  const Eigen::VectorXd from = Eigen::Map<const Eigen::VectorXd>(theta.data(), at(theta.size()));
  nearest_ = nearest_admissible(*admissible_, from + step, root_of(information), std::sqrt(tolerance_));
  return nearest_.theta - from;
}

bool LikelihoodEstimator::project(LikelihoodFit& fit, double tolerance, const FitWatcher& watch) {
  relax_all(fit.theta);
  if (admissible_ == nullptr) choose_tolerance();
  weigh();
  double loss = total(fit.theta);
  double last = 0.0, ratio = shrinks_;
  int crawling = 0;  // steps in a row of which next to nothing helped
  Eigen::VectorXd gradient, taken;
  while (fit.iterations < most_iterations) {
    watch(++fit.iterations);
    linearise_all(fit.theta);
    const Eigen::VectorXd before_taken = std::exchange(gradient, {});
    sum(fit.theta, fit.information, gradient);
    if (taken.size() > 0) secants_.note(taken, before_taken - gradient, fit.information);
    const Eigen::VectorXd step = joint_step(fit.theta, fit.information, gradient);
    const double size = norm_of(step, fit.information) / std::sqrt(tolerance_);
    const std::vector<Line> before = lines_;
    double scale = 1.0;
    for (int attempt = 0;; ++attempt, scale *= 0.25) {
      if (attempt == 8) {
        lines_ = before;
        return size < tolerance;
      }
      const std::vector<double> next = added(fit.theta, step, scale);
      follow(before, next, scale * step);
      const double reached = total(next);
      if (!(reached <= loss * (1.0 + 1e-9))) continue;
      loss = reached;
      fit.theta = next;
      break;
    }
    taken = scale * step;
    weigh();
    crawling = scale < 0.01 ? crawling + 1 : 0;
    if (crawling == 3) return false;
    if (last > 0.0) shrinks_ = ratio = size / last;
    if (left_after(size, std::max(ratio, least_ratio)) < misfit_of(loss) * tolerance) return true;
    last = size;
  }
  return false;
}

LikelihoodFit LikelihoodEstimator::run_from(std::vector<double> start, const FitWatcher& watch) {
  observations_.weigh_as_measured();
  LikelihoodFit fit = begun(std::move(start));
  if (!observations_.layout().a.empty()) whitened_stage(fit, 4, 1.0, watch);
  implicit_stage(fit, watch);
  if (observations_.variances_by_law()) {
    relax_all(fit.theta);
    weigh_at_states(fit.theta);
  }
  fit.converged = project(fit, 0.1, watch);
  for (double before = 2.0 * tolerance_; fit.converged && tolerance_ > 1.0 && tolerance_ < 0.9 * before;) {
    before = tolerance_;  // lines that fit better now may tell others as outlying
    fit.converged = project(fit, 0.1, watch);
  }
  while (fit.converged && observations_.variances_by_law() && fit.iterations < most_iterations) {
    const std::vector<double> before = fit.theta;
    weigh_at_states(fit.theta);
    fit.converged = project(fit, 0.1, watch);
    Eigen::VectorXd moved(at(unknowns_));
    for (std::size_t i = 0; i < unknowns_; ++i) moved[at(i)] = fit.theta[i] - before[i];
    if (norm_of(moved, fit.information) < 10.0 * settled * std::sqrt(tolerance_)) break;
  }
  if (fit.converged) fit.converged = project(fit, settled, watch);
  finish(fit);
  return fit;
}

LikelihoodFit LikelihoodEstimator::run_whitened(std::vector<double> start, const FitWatcher& watch) {
  observations_.weigh_as_measured();
  LikelihoodFit fit = begun(std::move(start));
  fit.converged = whitened_stage(fit, 50, 1e-3, watch);
  finish(fit);
  return fit;
}

LikelihoodFit LikelihoodEstimator::begun(std::vector<double> start) {
  LikelihoodFit fit;
  fit.theta = std::move(start);
  secants_.forget();
  shrinks_ = 1.0;
  begin(fit.theta);
  return fit;
}

void LikelihoodEstimator::finish(LikelihoodFit& fit) const {
  fit.loss = total(fit.theta);
  for (const Line& line : lines_) {
    fit.line_cost.push_back(line.cost);
    fit.line_weight.push_back(line.weight);
    const LineState& state = line.state;
    const ReducedLine& reduced = line.reduced;
    fit.bytes += sizeof(Line) + sizeof(Complex) * static_cast<std::size_t>(state.x.size() + state.y.size() + state.a.size() + state.b.size()) +
                 sizeof(double) * static_cast<std::size_t>(reduced.information.size() + reduced.gradient.size() + reduced.back.size() +
                                                           reduced.own.size());
  }
}

LikelihoodFit LikelihoodEstimator::refine(std::vector<double> start, const FitWatcher& watch) {
  LikelihoodFit fit = begun(std::move(start));
  fit.converged = project(fit, 1e-2, watch);
  finish(fit);
  return fit;
}

ConstrainedFit LikelihoodEstimator::constrain(LikelihoodFit fit, const AdmissibleSet& set, const FitWatcher& watch) {
  const auto vector = [](const std::vector<double>& theta) { return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(theta.data(), at(theta.size()))); };
  AdmissibleFit unmoved = nearest_admissible(set, vector(fit.theta), root_of(fit.information), std::sqrt(tolerance_));
  if (unmoved.theta == vector(fit.theta)) return {std::move(fit), std::move(unmoved)};
  const std::size_t before = std::exchange(fit.iterations, 0);
  fit.converged = project(fit, settled, watch) && fit.converged;  // so that both minima are of the same weights
  const double free_loss = total(fit.theta);
  const Eigen::VectorXd free = vector(fit.theta);
  admissible_ = &set;
  nearest_ = nearest_admissible(set, free, root_of(fit.information), std::sqrt(tolerance_));
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
  fit.bytes = 0;
  finish(fit);
  ConstrainedFit out{std::move(fit), std::move(nearest_)};
  out.admissible.theta = vector(out.fit.theta);
  share_out(free, moves ? std::max(0.0, out.fit.loss - free_loss) : 0.0, tie_share, out.admissible);
  return out;
}

void LikelihoodEstimator::weigh_at_states(const std::vector<double>& theta) {
  if (!observations_.variances_by_law()) return;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (lines_[i].redundancy > 0.0) observations_.weigh_at(i, lines_[i].state, lines_[i].joint.at(theta));
  }
}

/// At most one line in five is outlying, and χ² of the others is within five standard deviations of its expectation.
bool LikelihoodEstimator::fits(const LikelihoodFit& fit) const {
  double chi_square = 0.0, expected = -static_cast<double>(unknowns_);
  std::size_t fitting = 0, outliers = 0;
  for (const Line& line : lines_) {
    if (line.redundancy <= 0.0) continue;
    if (line.cost > outlying * line.redundancy) {
      ++outliers;
      continue;
    }
    ++fitting;
    chi_square += line.cost;
    expected += line.redundancy;
  }
  return fit.converged && 4 * outliers <= fitting && chi_square <= expected + 5.0 * std::sqrt(2.0 * std::max(0.0, expected));
}

namespace {

std::ptrdiff_t times_reached(double loss, const std::vector<LikelihoodFit::End>& ends) {
  return std::ranges::count_if(ends, [loss](const LikelihoodFit::End& end) { return end.loss <= loss + 1e-3 * std::max(1.0, loss); });
}

}  // namespace

LikelihoodFit LikelihoodEstimator::run(const Starts& starts, const FitWatcher& watch, Follow follow, const Doubt& doubtful) {
  LikelihoodFit best;
  std::vector<LikelihoodFit::End> ends;
  std::vector<Line> lines;  // of the best
  bool any = false;
  for (std::size_t k = 0;; ++k) {
    const auto start = starts(k);
    if (!start) break;
    LikelihoodFit fit = run_from(*start, watch);
    if (fit.converged) ends.push_back({fit.loss, fit.theta});
    if (!any || (fit.loss < best.loss - 1e-3 && fit.converged >= best.converged)) {
      best = std::move(fit);
      lines = lines_;
    }
    any = true;
    best.starts = k + 1;
    if (follow == Follow::all || !fits(best)) continue;
    if (follow == Follow::until_reached_twice ? times_reached(best.loss, ends) > 1 : !(doubtful && doubtful(best))) break;
  }
  best.ends = std::move(ends);
  lines_ = std::move(lines);
  weigh_at_states(best.theta);
  return best;
}

double LikelihoodEstimator::misfit_at(const std::vector<double>& theta) {
  begin(theta);
  linearise_all(theta);
  double misfit = 0.0, redundancy = 0.0;
  for (const Line& line : lines_) {
    if (line.redundancy <= 0.0) continue;
    misfit += line.redundancy * std::log1p(line.reduced.cost / line.redundancy);
    redundancy += line.redundancy;
  }
  return redundancy > 0.0 ? misfit / redundancy : 0.0;
}

Eigen::MatrixXd LikelihoodEstimator::information_at(const std::vector<double>& theta) {
  begin(theta);
  relax_all(theta);
  linearise_all(theta);
  for (Line& line : lines_) line.weight = 1.0;
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  sum(theta, information, gradient);
  return information;
}

Eigen::MatrixXd LikelihoodEstimator::godambe_information_at(const LikelihoodFit& fit) {
  const std::vector<Line> there = lines_;
  const auto gradient_at = [&](const Eigen::VectorXd& offset) {
    lines_ = there;
    const std::vector<double> theta = added(fit.theta, offset, 1.0);
    relax_all(theta);
    linearise_all(theta);
    Eigen::MatrixXd information;
    Eigen::VectorXd gradient;
    sum(theta, information, gradient);
    return gradient;
  };
  Eigen::MatrixXd curvature = godambe_information(gradient_at, fit.information);
  lines_ = there;
  return curvature;
}

Eigen::MatrixXd LikelihoodEstimator::information_of(std::size_t line) const {
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(at(unknowns_), at(unknowns_));
  if (lines_[line].redundancy > 0.0) add_information(lines_[line], 1.0, information);
  return information;
}

void LikelihoodEstimator::add_information(const Line& line, double weight, Eigen::MatrixXd& information) {
  const auto& columns = line.joint.columns();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    for (std::size_t j = 0; j < columns.size(); ++j) {
      information(at(columns[i]), at(columns[j])) += weight * line.reduced.information(at(i), at(j));
    }
  }
}

}  // namespace jointid::ident
