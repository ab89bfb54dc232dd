#include "ident/likelihood/bundle/bundle.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "base/eigen.hpp"
#include "dense/pivoted_qr.hpp"
#include "ident/likelihood/bundle/bundle_functions.hpp"
#include "ident/likelihood/model/line_start.hpp"
#include "ident/likelihood/line/line_tolerance.hpp"
#include "minimise/linear/covariance.hpp"

namespace jointid::ident {
namespace {

/// A line with χ² above this multiple of its redundancy may be stuck.
constexpr double suspicious = 4.0;

minimise::BlockOptions tight_options(int iterations) {
  return {.most_iterations = iterations, .function_tolerance = 1e-14, .parameter_tolerance = 1e-10, .gradient_tolerance = 1e-8};
}

class Bundle {
 public:
  Bundle(LikelihoodData& observations, const restrictions::Restriction& restriction, const UnknownColumns& columns, double omega0,
         const LikelihoodFit& start, const FitWatcher& watch);

  LikelihoodFit run();

 private:
  struct Line {
    std::size_t number;
    double redundancy;
    JointImpedance joint;
    ExplicitLine explicit_line;
    std::vector<double> u;
    double cost = 0.0;
    bool settled = false;  ///< the last time it was relaxed
  };

  void choose(Line& line, const LineState& state) const;
  void relax(Line& line, int iterations);
  bool relax_from(Line& line, const LineState& start, int iterations);
  bool relax_stuck(double above);
  void choose_tolerance();
  double limit(const Line& line) const { return outlying * tolerance_ * line.redundancy; }
  void solve();
  void reduce();
  double total() const;
  void step_over();
  void settle();
  void weigh();
  std::vector<double> theta() const { return scale_.theta(t_.data()); }
  void finish();

  LikelihoodData& observations_;
  const FitWatcher& watch_;
  JointScale scale_;
  std::vector<double> t_;
  std::vector<Line> lines_;
  double tolerance_ = 1.0;  ///< χ² over its expectation that counts as fitting
  Eigen::VectorXd step_;  ///< of theta, see reduce()
  LikelihoodFit fit_;
};

Bundle::Bundle(LikelihoodData& observations, const restrictions::Restriction& restriction, const UnknownColumns& columns,
               double omega0, const LikelihoodFit& start, const FitWatcher& watch)
    : observations_(observations), watch_(watch), scale_{start.theta, {}}, t_(start.theta.size(), 0.0) {
  const Eigen::VectorXd variances = minimise::covariance_of(start.information).diagonal();
  for (Eigen::Index i = 0; i < variances.size(); ++i) scale_.scale.push_back(std::sqrt(variances[i]));
  for (std::size_t i = 0; i < observations.lines().size(); ++i) {
    const LineData& data = observations.lines()[i];
    const JointImpedance joint = joint_at(restriction, columns, omega0, data.omega);
    const double redundancy = data.redundancy(observations.layout());
    if (redundancy <= 0.0 || joint.columns().empty()) continue;
    lines_.push_back({i, redundancy, joint, ExplicitLine(observations.layout(), data, joint), {}, 0.0, false});
  }
  fit_.iterations = start.iterations;
}

void Bundle::choose(Line& line, const LineState& state) const {
  line.explicit_line.set_centre(state.sub_jn, state.sub_jj);
  line.u.assign(line.explicit_line.own(), 0.0);
}

/// Minimises the line's χ² over its FRFs for the current joint.
void Bundle::relax(Line& line, int iterations) {
  const LineCost cost(line.explicit_line, scale_);
  minimise::BlockOptions options = tight_options(iterations);
  options.constant = t_.data();
  const minimise::BlockMinimum found = minimise::ceres_blocks({{.block = &cost, .parameters = {t_.data(), line.u.data()}}}, options);
  line.cost = found.cost;
  line.settled = found.converged;
}

/// Keeps what `start` leads to if it is better.
bool Bundle::relax_from(Line& line, const LineState& start, int iterations) {
  const Line before = line;
  choose(line, start);
  relax(line, iterations);
  if (line.cost < before.cost * (1.0 - 1e-6)) return true;
  line = before;
  return false;
}

/// Lines with χ² beyond `above` redundancies once more from where the data put them: the measured FRFs, and, where that does not fit,
/// lifted_start(). Where most lines do not fit it is the joint, and lifting them, which costs most, would not help.
bool Bundle::relax_stuck(double above) {
  const LineLayout& layout = observations_.layout();
  bool better = false;
  std::vector<Line*> left;
  for (Line& line : lines_) {
    if (line.cost <= above * line.redundancy) continue;
    watch_(fit_.iterations);
    better = relax_from(line, measured_start(layout, observations_.lines()[line.number]), 50) || better;
    if (!line.settled || line.cost > suspicious * line.redundancy) left.push_back(&line);
  }
  if (2 * left.size() > lines_.size()) return better;
  for (Line* line : left) {
    watch_(fit_.iterations);
    const LineData& data = observations_.lines()[line->number];
    better = relax_from(*line, lifted_start(layout, data, line->explicit_line.impedance(theta())), 300) || better;
  }
  return better;
}

void Bundle::choose_tolerance() {
  std::vector<double> ratios;
  for (const Line& line : lines_) ratios.push_back(line.cost / line.redundancy);
  if (!ratios.empty()) tolerance_ = line_tolerance(std::move(ratios));
}

void Bundle::solve() {
  choose_tolerance();
  std::deque<LineCost> costs;
  std::deque<LineLoss> losses;
  std::vector<minimise::BlockTerm> terms;
  for (Line& line : lines_) {
    terms.push_back({&costs.emplace_back(line.explicit_line, scale_), &losses.emplace_back(limit(line)), {t_.data(), line.u.data()}});
  }
  minimise::BlockOptions options = tight_options(150);
  options.common = t_.data();
  options.after_iteration = [&] { watch_(++fit_.iterations); };
  minimise::ceres_blocks(terms, options);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const double* parameters[] = {t_.data(), lines_[i].u.data()};
    std::vector<double> residuals(lines_[i].explicit_line.residuals());
    costs[i].evaluate(parameters, residuals.data(), nullptr);
    lines_[i].cost = Eigen::Map<const Eigen::VectorXd>(residuals.data(), at(residuals.size())).squaredNorm();
  }
}

/// Information and gradient of the joint with the lines' FRFs projected out: Fᵀ(I − QQᵀ)F and −Fᵀ(I − QQᵀ)r of the Jacobian
/// [E F] and the residuals r, E = QR.
void Bundle::reduce() {
  const auto p = at(t_.size());
  fit_.information = Eigen::MatrixXd::Zero(p, p);
  step_ = Eigen::VectorXd::Zero(p);
  for (const Line& line : lines_) {
    RowMatrixXd by_theta, by_own;
    Eigen::VectorXd residuals(at(line.explicit_line.residuals()));
    line.explicit_line.evaluate(theta(), line.u.data(), residuals.data(), &by_theta, &by_own);
    const dense::RealPivotedQr factors(by_own);
    const Eigen::MatrixXd rotated = factors.rotated(by_theta);
    const Eigen::VectorXd right = factors.rotated(residuals);
    const auto left = rotated.rows() - factors.rank();
    double rho[3];
    LineLoss(limit(line)).evaluate(line.cost, rho);
    fit_.information += rho[1] * rotated.bottomRows(left).transpose() * rotated.bottomRows(left);
    step_ -= rho[1] * rotated.bottomRows(left).transpose() * right.tail(left);
  }
  const Eigen::VectorXd gradient = step_;
  step_ = minimise::covariance_of(fit_.information) * gradient;
  fit_.converged = std::sqrt(std::max(0.0, step_.dot(gradient))) < 1e-3;
}

double Bundle::total() const {
  double sum = 0.0;
  for (const Line& line : lines_) {
    double rho[3];
    LineLoss(limit(line)).evaluate(line.cost, rho);
    sum += rho[0];
  }
  return sum;
}

/// Where a line that must follow the joint exactly holds up the common steps: the step that the joint would take with its lines
/// projected out, and the lines after it.
void Bundle::step_over() {
  const auto lines = lines_;
  const std::vector<double> t = t_;
  const double before = total();
  for (std::size_t i = 0; i < t_.size(); ++i) t_[i] += step_[at(i)] / scale_.scale[i];
  for (Line& line : lines_) {
    watch_(fit_.iterations);
    relax(line, 100);
  }
  relax_stuck(suspicious);
  if (total() < before) return;
  lines_ = lines;
  t_ = t;
}

void Bundle::settle() {
  constexpr int most = 8;
  for (int round = 0; round < most; ++round) {
    solve();
    const bool better = relax_stuck(suspicious);
    reduce();
    if (fit_.converged && !better) return;
    if (!fit_.converged) step_over();
  }
}

/// Weights at the estimated values.
void Bundle::weigh() {
  for (Line& line : lines_) {
    const LineState state = line.explicit_line.state(theta(), line.u.data());
    observations_.weigh_at(line.number, state, line.explicit_line.impedance(theta()));
    line.explicit_line = ExplicitLine(observations_.layout(), observations_.lines()[line.number], line.joint);
    choose(line, state);
  }
}

void Bundle::finish() {
  fit_.theta = theta();
  fit_.line_cost.assign(observations_.lines().size(), 0.0);
  fit_.line_weight.assign(observations_.lines().size(), 0.0);
  for (const Line& line : lines_) {
    const std::size_t rows = line.explicit_line.residuals(), own = line.u.size();
    double rho[3];
    LineLoss(limit(line)).evaluate(line.cost, rho);
    fit_.line_cost[line.number] = line.cost;
    fit_.line_weight[line.number] = rho[1];
    fit_.bytes += sizeof(double) * (rows * (1 + t_.size() + own) + own * own);
  }
}

LikelihoodFit Bundle::run() {
  constexpr int most = 6;
  for (Line& line : lines_) line.cost = std::numeric_limits<double>::infinity();
  relax_stuck(0.0);
  settle();
  for (int round = 0; round < most && observations_.variances_by_law(); ++round) {
    const std::vector<double> before = t_;
    weigh();
    settle();
    Eigen::VectorXd moved(at(t_.size()));
    for (std::size_t i = 0; i < t_.size(); ++i) moved[at(i)] = (t_[i] - before[i]) * scale_.scale[i];
    if (std::sqrt(moved.dot(fit_.information * moved)) < 1e-2) break;
  }
  finish();
  return std::move(fit_);
}

}  // namespace

LikelihoodFit adjust_bundle(LikelihoodData& observations, const restrictions::Restriction& restriction,
                            const UnknownColumns& columns, double omega0, const LikelihoodFit& start, const FitWatcher& watch) {
  return Bundle(observations, restriction, columns, omega0, start, watch).run();
}

}  // namespace jointid::ident
