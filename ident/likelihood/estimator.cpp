#include "ident/likelihood/estimator.hpp"

#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace jointid::ident {
namespace {

Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }

/// A line with χ² above this multiple of its redundancy (squared) counts for less.
constexpr double outlying = 1.5 * 1.5;

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

/// Solves information · step = gradient with unit diagonal; directions without information stay.
Eigen::VectorXd solve_step(const Eigen::MatrixXd& information, const Eigen::VectorXd& gradient) {
  const Eigen::VectorXd scale = information.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * information * scale.asDiagonal();
  const Eigen::LDLT<Eigen::MatrixXd> factors(scaled);
  const Eigen::VectorXd right = scale.asDiagonal() * gradient;
  const Eigen::VectorXd step = factors.solve(right);
  return scale.asDiagonal() * step;
}

Eigen::VectorXd pick(const Eigen::VectorXd& all, const std::vector<std::size_t>& which) {
  Eigen::VectorXd out(at(which.size()));
  for (std::size_t i = 0; i < which.size(); ++i) out[at(i)] = all[at(which[i])];
  return out;
}

/// Where H_sub(j,j) is not measured: what A = (I + Y Z)⁻¹ X makes of the measured A and X, Y = (X − A)(Z A)⁺.
void guess_y(const LineLayout& layout, const LineData& data, const ComplexMatrix& z, LineState& state) {
  const auto unknown = [](const Complex& weight) { return weight == Complex(0.0); };
  if (std::none_of(data.y.weight.begin(), data.y.weight.end(), unknown)) return;
  ComplexMatrix a = ComplexMatrix::Zero(state.x.rows(), state.x.cols());
  for (std::size_t v = 0; v < layout.a.size(); ++v) a(at(layout.a[v].row), at(layout.a[v].column)) = data.a.value[v];
  const ComplexMatrix za = z * a, rest = state.x - a;
  const Eigen::BDCSVD<ComplexMatrix> svd(za.transpose(), Eigen::ComputeThinU | Eigen::ComputeThinV);
  const ComplexMatrix guess = svd.solve(ComplexMatrix(rest.transpose())).transpose();
  for (std::size_t v = 0; v < layout.y.size(); ++v) {
    if (!unknown(data.y.weight[v])) continue;
    const auto p = at(layout.y[v].row), q = at(layout.y[v].column);
    state.y(p, q) = state.y(q, p) = 0.5 * (guess(p, q) + guess(q, p));
  }
}

std::vector<double> added(std::vector<double> theta, const Eigen::VectorXd& step, double scale) {
  for (std::size_t i = 0; i < theta.size(); ++i) theta[i] += scale * step[at(i)];
  return theta;
}

}  // namespace

LikelihoodEstimator::LikelihoodEstimator(Observations& observations, const restrictions::Restriction& restriction,
                                         const UnknownColumns& columns, double omega0, std::size_t threads)
    : observations_(observations), unknowns_(columns.size()), threads_(threads) {
  for (const LineData& data : observations.lines()) {
    Line line{JointImpedance(restriction, columns, omega0, data.omega), {}, data.redundancy(observations.layout()), 0.0, 1.0, {}};
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

/// Measured values where there are, and for the rest what the joint makes of them.
void LikelihoodEstimator::begin(const std::vector<double>& theta) {
  const LineLayout& layout = observations_.layout();
  const auto n = at(layout.others), joint = at(layout.joint);
  for_lines([&](std::size_t i, LineModel&) {
    const LineData& data = observations_.lines()[i];
    LineState& state = lines_[i].state;
    state.x = ComplexMatrix::Zero(joint, n);
    state.y = ComplexMatrix::Zero(joint, joint);
    for (std::size_t v = 0; v < layout.x.size(); ++v) state.x(at(layout.x[v].row), at(layout.x[v].column)) = data.x.value[v];
    for (std::size_t v = 0; v < layout.y.size(); ++v) {
      state.y(at(layout.y[v].row), at(layout.y[v].column)) = state.y(at(layout.y[v].column), at(layout.y[v].row)) = data.y.value[v];
    }
    const ComplexMatrix z = lines_[i].joint.at(theta);
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
  });
}

void LikelihoodEstimator::weigh() {
  for (Line& line : lines_) line.weight = line.redundancy > 0.0 ? robust_weight(line.cost / tolerance_, line.redundancy) : 0.0;
}

/// How much more than expected the lines are off at the middle: while most of them do not fit, that is no reason to trust a few.
void LikelihoodEstimator::choose_tolerance() {
  std::vector<double> ratios;
  for (const Line& line : lines_) {
    if (line.redundancy > 0.0) ratios.push_back(line.cost / line.redundancy);
  }
  if (ratios.empty()) return;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  tolerance_ = *middle > outlying ? *middle : 1.0;
}

double LikelihoodEstimator::total() const {
  double sum = 0.0;
  for (const Line& line : lines_) {
    if (line.redundancy > 0.0) sum += tolerance_ * robust_loss(line.cost / tolerance_, line.redundancy);
  }
  return sum;
}

void LikelihoodEstimator::sum(Eigen::MatrixXd& information, Eigen::VectorXd& gradient) const {
  information = Eigen::MatrixXd::Zero(at(unknowns_), at(unknowns_));
  gradient = Eigen::VectorXd::Zero(at(unknowns_));
  for (const Line& line : lines_) {
    const auto& columns = line.joint.columns();
    if (line.redundancy <= 0.0) continue;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      gradient[at(columns[i])] += line.weight * line.reduced.gradient[at(i)];
      for (std::size_t j = 0; j < columns.size(); ++j) {
        information(at(columns[i]), at(columns[j])) += line.weight * line.reduced.information(at(i), at(j));
      }
    }
  }
}

void LikelihoodEstimator::linearise_all(const std::vector<double>& theta) {
  for_lines([&](std::size_t i, LineModel& model) {
    Line& line = lines_[i];
    model.linearise(observations_.lines()[i], line.joint, line.joint.at(theta), line.state, true);
    std::optional<ReducedLine> reduced = model.reduce(0.0);
    for (double damping = 1e-3; !reduced && damping < 1e12; damping *= 10.0) reduced = model.reduce(damping);
    if (reduced) line.reduced = std::move(*reduced);
  });
}

/// Iterative quadratic maximum likelihood: the conditions at the measured FRFs, which are linear in the joint, whitened by the
/// covariance that the last joint gives them.
bool LikelihoodEstimator::whitened_stage(LikelihoodFit& fit, std::size_t most, double tolerance, const FitWatcher& watch) {
  Eigen::VectorXd gradient;
  for (std::size_t iteration = 0; iteration < most; ++iteration) {
    watch(++fit.iterations);
    linearise_all(fit.theta);
    for (Line& line : lines_) line.cost = line.reduced.cost;
    choose_tolerance();
    weigh();
    sum(fit.information, gradient);
    const Eigen::VectorXd step = solve_step(fit.information, gradient);
    fit.theta = added(fit.theta, step, 1.0);
    if (std::sqrt(step.dot(fit.information * step)) < tolerance) return true;
  }
  return false;
}

void LikelihoodEstimator::implicit_stage(LikelihoodFit& fit, const FitWatcher& watch) {
  constexpr std::size_t most = 15;
  constexpr double near = 0.3;  // in standard deviations: close enough for the second stage
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  for (std::size_t iteration = 0; iteration < most; ++iteration) {
    watch(++fit.iterations);
    linearise_all(fit.theta);
    for (Line& line : lines_) line.cost = line.reduced.cost;
    choose_tolerance();
    weigh();
    sum(information, gradient);
    const Eigen::VectorXd step = solve_step(information, gradient);
    const std::vector<double> next = added(fit.theta, step, 1.0);
    for_lines([&](std::size_t i, LineModel& model) {
      Line& line = lines_[i];
      const ComplexMatrix z = line.joint.at(fit.theta);
      model.linearise(observations_.lines()[i], line.joint, z, line.state, false);
      const LineStep own = line.reduced.own - line.reduced.back * pick(step, line.joint.columns());
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

void LikelihoodEstimator::relax_all(const std::vector<double>& theta) {
  for_lines([&](std::size_t i, LineModel& model) {
    const ComplexMatrix z = lines_[i].joint.at(theta);
    relax(i, model, z);
    Line& line = lines_[i];
    if (line.cost <= 4.0 * line.redundancy) return;
    // A line far from fitting may be stuck: once more from the measured values.
    const LineLayout& layout = observations_.layout();
    const LineData& data = observations_.lines()[i];
    const LineState kept = line.state;
    const double cost = line.cost;
    for (std::size_t v = 0; v < layout.x.size(); ++v) {
      if (data.x.weight[v] != Complex(0.0)) line.state.x(at(layout.x[v].row), at(layout.x[v].column)) = data.x.value[v];
    }
    for (std::size_t v = 0; v < layout.y.size(); ++v) {
      if (data.y.weight[v] == Complex(0.0)) continue;
      line.state.y(at(layout.y[v].row), at(layout.y[v].column)) = line.state.y(at(layout.y[v].column), at(layout.y[v].row)) = data.y.value[v];
    }
    relax(i, model, z);
    if (line.cost < cost) return;
    line.state = kept;
    line.cost = cost;
  });
}

bool LikelihoodEstimator::project(LikelihoodFit& fit, double tolerance, const FitWatcher& watch) {
  constexpr std::size_t most = 60;
  const LineLayout& layout = observations_.layout();
  relax_all(fit.theta);
  choose_tolerance();
  weigh();
  double loss = total();
  Eigen::VectorXd gradient;
  for (std::size_t iteration = 0; iteration < most; ++iteration) {
    watch(++fit.iterations);
    linearise_all(fit.theta);
    sum(fit.information, gradient);
    const Eigen::VectorXd step = solve_step(fit.information, gradient);
    const double size = std::sqrt(std::max(0.0, step.dot(fit.information * step)));
    const std::vector<Line> before = lines_;
    double scale = 1.0;
    bool better = false;
    for (int attempt = 0; attempt < 8 && !better; ++attempt, scale *= 0.25) {
      const std::vector<double> next = added(fit.theta, step, scale);
      for_lines([&](std::size_t i, LineModel&) {
        Line& line = lines_[i];
        line.state = before[i].state;
        const ComplexMatrix z = line.joint.at(next);
        ComplexMatrix x = line.state.x, y = line.state.y;
        const LineStep follow = -(before[i].reduced.back * pick(step, line.joint.columns()));
        move(layout, follow, scale, x, y);
        const LineData& data = observations_.lines()[i];
        if (line_cost(layout, data, z, x, y) <= line_cost(layout, data, z, line.state.x, line.state.y)) {
          line.state.x = std::move(x);
          line.state.y = std::move(y);
        }
      });
      relax_all(next);
      const double reached = total();
      if (reached <= loss * (1.0 + 1e-9)) {
        better = true;
        loss = reached;
        fit.theta = next;
        weigh();
        if (size * scale < tolerance) return true;
      }
    }
    if (!better) {
      lines_ = before;
      return size < tolerance;
    }
  }
  return false;
}

LikelihoodFit LikelihoodEstimator::run(std::vector<double> start, const FitWatcher& watch) {
  LikelihoodFit fit;
  fit.theta = std::move(start);
  begin(fit.theta);
  whitened_stage(fit, 4, 1.0, watch);
  implicit_stage(fit, watch);
  for (int round = 0; round < 10 && !(project(fit, 0.1, watch) && tolerance_ == 1.0); ++round) {
  }
  if (!observations_.variances_by_law()) fit.converged = project(fit, 1e-3, watch);
  for (int round = 0; round < 6 && observations_.variances_by_law(); ++round) {
    const std::vector<double> before = fit.theta;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      if (lines_[i].redundancy > 0.0) observations_.weigh_at(i, lines_[i].state, lines_[i].joint.at(fit.theta));
    }
    fit.converged = project(fit, 1e-3, watch);
    Eigen::VectorXd moved(at(unknowns_));
    for (std::size_t i = 0; i < unknowns_; ++i) moved[at(i)] = fit.theta[i] - before[i];
    if (std::sqrt(std::max(0.0, moved.dot(fit.information * moved))) < 1e-2) break;
  }
  finish(fit);
  return fit;
}

LikelihoodFit LikelihoodEstimator::run_whitened(std::vector<double> start, const FitWatcher& watch) {
  LikelihoodFit fit;
  fit.theta = std::move(start);
  begin(fit.theta);
  fit.converged = whitened_stage(fit, 50, 1e-3, watch);
  finish(fit);
  return fit;
}

void LikelihoodEstimator::finish(LikelihoodFit& fit) const {
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

Eigen::MatrixXd LikelihoodEstimator::information_at(const std::vector<double>& theta) {
  begin(theta);
  relax_all(theta);
  linearise_all(theta);
  for (Line& line : lines_) line.weight = 1.0;
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  sum(information, gradient);
  return information;
}

}  // namespace jointid::ident
