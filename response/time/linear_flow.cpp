#include "response/time/linear_flow.hpp"

#include <algorithm>
#include <cmath>

#include "dense/cholesky.hpp"
#include "dense/eigen.hpp"
#include "response/time/collocation.hpp"

namespace jointid::response {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Bound of the frequencies of the structure with its joints at least as stiff as they can be, and of its rates of decay.
double highest_rate(const JointedStructure& s, const VectorXd& stiffness) {
  const MatrixXd k = s.matrices.stiffness + s.incidence * stiffness.asDiagonal() * s.incidence.transpose();
  const double square = dense::symmetric_eigen(k, s.matrices.mass).values.cwiseAbs().maxCoeff();
  const double decay = dense::symmetric_eigen(s.matrices.damping, s.matrices.mass).values.cwiseAbs().maxCoeff();
  return std::sqrt(square) + decay;
}

}  // namespace

LinearFlow::LinearFlow(const JointedStructure& s, const ForceHistory& force, const std::vector<std::optional<double>>& stiffness,
                       double limit) {
  const Index n = s.coordinates(), joints = s.joints(), inputs = force.load().cols(), size = 2 * n + joints + inputs;
  MatrixXd right(n, 2 * n + joints + inputs);
  right << s.matrices.stiffness, s.matrices.damping, s.incidence, -force.load();
  const MatrixXd acceleration = -dense::solve_positive(s.matrices.mass, right);
  a_ = MatrixXd::Zero(size, size);
  a_.block(0, n, n, n).setIdentity();
  a_.middleRows(n, n) = acceleration;
  a_.bottomRightCorner(inputs, inputs) = force.generator();
  VectorXd steepest(joints);
  for (Index j = 0; j < joints; ++j) {
    const auto& straight = stiffness[static_cast<std::size_t>(j)];
    if (straight) {
      a_.block(2 * n + j, n, 1, n) = *straight * s.incidence.col(j).transpose();
    } else {
      curved_.push_back(j);
    }
    steepest[j] = straight ? *straight : s.laws[static_cast<std::size_t>(j)]->response(0.0).tangent;
  }
  b_ = MatrixXd::Zero(size, at(curved_.size()));
  for (std::size_t c = 0; c < curved_.size(); ++c) {
    b_.col(at(c)) = a_.col(2 * n + curved_[c]);
    a_.col(2 * n + curved_[c]).setZero();
  }
  const double rate = highest_rate(s, steepest) + force.highest_frequency();
  longest_step_ = std::min(rate > 0.0 ? 1.0 / rate : 1.0, limit);

  MatrixXd row = MatrixXd::Zero(joints, size);
  row.leftCols(n) = s.incidence.transpose();
  for (int k = 0; k <= terms; ++k) {
    rows_.push_back(row);
    markov_.push_back(row * b_);
    row = row * a_;
  }
}

MatrixXd LinearFlow::series(const VectorXd& z, double h, const MatrixXd& forces) const {
  MatrixXd series(z.size(), terms);
  series.col(0) = z;
  for (int k = 0; k + 1 < terms; ++k) {
    VectorXd rate = a_ * series.col(k);
    if (k < forces.cols()) rate += b_ * forces.col(k);
    series.col(k + 1) = h / (k + 1) * rate;
  }
  return series;
}

bool LinearFlow::remembers(double h) const {
  int exponent = 0;
  return std::frexp(h / longest_step_, &exponent) == 0.5;
}

const StepMatrices& LinearFlow::step_matrices(double h) {
  if (!remembers(h)) return other_step_ = make_step_matrices(h);
  const auto found = steps_.find(h);
  return found != steps_.end() ? found->second : steps_.emplace(h, make_step_matrices(h)).first->second;
}

const Influence& LinearFlow::influence(double h) {
  if (!remembers(h)) {
    if (h != other_length_) other_influence_ = make_influence(h);
    other_length_ = h;
    return other_influence_;
  }
  const auto found = influences_.find(h);
  return found != influences_.end() ? found->second : influences_.emplace(h, make_influence(h)).first->second;
}

StepMatrices LinearFlow::make_step_matrices(double h) const {
  StepMatrices step;
  const Index size = a_.rows();
  step.transition.setIdentity(size, size);
  MatrixXd power = MatrixXd::Identity(size, size);
  for (int k = 1; k < terms; ++k) {
    power = h / k * (a_ * power);
    step.transition += power;
  }
  const int points = Collocation::points;
  step.input.setZero(size, at(curved_.size()) * points);
  for (Index c = 0; c < at(curved_.size()); ++c) {
    // ∫ e^{A(h−σ)} b (σ/h)^p dσ = Σ_k A^k b h^{k+1} p!/(k+p+1)!
    MatrixXd moments = MatrixXd::Zero(size, points);
    VectorXd term = b_.col(c);
    for (int k = 0; k < terms; ++k) {
      for (int p = 0; p < points; ++p) moments.col(p) += h * std::beta(k + 1.0, p + 1.0) * term;
      term = h / (k + 1) * (a_ * term);
    }
    step.input.middleCols(c * points, points) = moments * Collocation::rule().to_monomials;
  }
  return step;
}

/// q (derivative 0), q̇ or q̈ of all joints at σh by the forces at Gauss's points:
/// Σ_k WᵀA^kB h^{k+1−d} p!/(k+p+1−d)! σ^{k+p+1−d}, from k = 1 on: a force moves no joint at once.
MatrixXd LinearFlow::influence_at(double h, double sigma, int derivative) const {
  constexpr int points = Collocation::points;
  const Index joints = rows_[0].rows(), curved = at(curved_.size());
  MatrixXd moments(joints * curved, points);
  for (int p = 0; p < points; ++p) {
    double factor = std::pow(sigma, p);
    for (int i = 1; i <= 2 - derivative; ++i) factor *= sigma * h / (p + i);
    MatrixXd sum = MatrixXd::Zero(joints, curved);
    for (int k = 1; k < terms; ++k) {
      sum += factor * markov(k);
      factor *= sigma * h / (k + p + 2 - derivative);
    }
    moments.col(p) = sum.reshaped();
  }
  const MatrixXd by_node = moments * Collocation::rule().to_monomials;
  MatrixXd result(joints, curved * points);
  for (Index c = 0; c < curved; ++c) result.middleCols(c * points, points) = by_node.middleRows(c * joints, joints);
  return result;
}

Influence LinearFlow::make_influence(double h) const {
  constexpr int points = Collocation::points;
  const Index curved = at(curved_.size());
  Influence influence;
  influence.nodes.resize(curved * points, curved * points);
  for (int i = 0; i < points; ++i) {
    const MatrixXd all = influence_at(h, Collocation::rule().nodes[i], 0);
    for (Index c = 0; c < curved; ++c) influence.nodes.row(c * points + i) = all.row(curved_[static_cast<std::size_t>(c)]);
  }
  for (int d = 0; d < 3; ++d) influence.end[static_cast<std::size_t>(d)] = influence_at(h, 1.0, d);
  return influence;
}

VectorXd sum_series(const MatrixXd& series, double sigma) {
  VectorXd sum = series.col(series.cols() - 1);
  for (Index k = series.cols() - 1; k-- > 0;) sum = series.col(k) + sigma * sum;
  return sum;
}

}  // namespace jointid::response
