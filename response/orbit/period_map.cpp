#include "response/orbit/period_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dense/eigen.hpp"

namespace jointid::response {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Row = JointState::Row;

PeriodMap::PeriodMap(const PeriodicProblem& problem, const MarchOptions& options)
    : omega_(problem.omega), period_(problem.period()), march_(problem.structure, problem.force(), options) {
  const std::size_t joints = problem.structure.laws.size();
  for (std::size_t j = 0; j < joints; ++j) {
    if (masing(j) == nullptr) bilinear_.push_back(at(j));
  }
  memory_.resize(joints);
  next_memory_.resize(joints);
  free_.resize(joints);
  state_ = image_ = pack();
}

MasingState* PeriodMap::masing(std::size_t joint) { return dynamic_cast<MasingState*>(march_.joint_states()[joint].get()); }

JenkinsState& PeriodMap::jenkins(Index row) const {
  const Index joint = bilinear_[static_cast<std::size_t>(row - 2 * march_.structure().coordinates())];
  return static_cast<JenkinsState&>(*march_.joint_states()[static_cast<std::size_t>(joint)]);
}

VectorXd PeriodMap::pack() const {
  const Motion motion = march_.motion();
  const Index n = motion.x.size();
  VectorXd state(2 * n + at(bilinear_.size()));
  state << motion.x, motion.v, motion.f(bilinear_);
  return state;
}

MatrixXd PeriodMap::rows_of_state() const {
  const Index n = march_.structure().coordinates();
  MatrixXd rows(2 * n + at(bilinear_.size()), march_.slopes().cols());
  rows.topRows(2 * n) = march_.slopes().topRows(2 * n);
  for (std::size_t b = 0; b < bilinear_.size(); ++b) rows.row(2 * n + at(b)) = march_.slopes().row(2 * n + bilinear_[b]);
  return rows;
}

void PeriodMap::place(Index columns) {
  const JointedStructure& structure = march_.structure();
  const Index n = structure.coordinates(), size = state_.size();
  VectorXd forces = VectorXd::Zero(structure.joints());
  MatrixXd seed = MatrixXd::Zero(2 * n + structure.joints(), columns);
  if (columns > 0) seed.topLeftCorner(2 * n, 2 * n).setIdentity();
  for (std::size_t b = 0; b < bilinear_.size(); ++b) {
    forces[bilinear_[b]] = state_[2 * n + at(b)];
    if (columns > 0) seed(2 * n + bilinear_[b], 2 * n + at(b)) = 1.0;
  }
  const VectorXd q = structure.incidence.transpose() * state_.head(n);
  Index next = size;
  for (std::size_t j = 0; j < memory_.size(); ++j) {
    march_.joint_states()[j]->follow(columns);
    MasingState* joint = masing(j);
    if (joint == nullptr) continue;
    if (!memory_[j].empty()) {
      Turns turns = memory_[j];
      for (auto& turn : turns) {
        if (columns != turn.slope.size()) turn.slope = Row::Zero(columns);
        if (columns > size) turn.slope = Row::Unit(columns, next++);  // corners as parameters of their own
      }
      joint->remember(turns, q[at(j)]);
    }
    joint->forget_turns();
  }
  march_.place(0.0, state_.head(n), state_.segment(n, n), forces);
  march_.follow(seed);
  for (Index row = 2 * n; row < size; ++row) jenkins(row).watch();
}

/// Those from the largest |q| on; earlier ones are forgotten in a period that begins there.
void PeriodMap::remember_turns() {
  for (std::size_t j = 0; j < memory_.size(); ++j) {
    const MasingState* joint = masing(j);
    if (joint == nullptr) continue;
    const Turns& turns = joint->turns();
    next_memory_[j] = memory_[j];
    if (turns.empty()) continue;
    const auto size = [](const MasingState::Turn& turn) { return std::abs(turn.displacement); };
    const auto displacement = [](const MasingState::Turn& turn) { return turn.displacement; };
    const auto largest = std::ranges::max_element(turns, {}, size);
    next_memory_[j].assign(largest, turns.end());
    const auto [low, high] = std::ranges::minmax_element(turns, {}, displacement);
    free_[j] = joint->keeps_residual_force(high->displacement - low->displacement);
  }
}

bool PeriodMap::run() {
  place(state_.size());
  const std::size_t before = march_.events();
  if (march_.march(period_) != MarchStatus::reached) return false;
  events_ = march_.events() - before;
  image_ = pack();
  derivative_ = rows_of_state();
  remember_turns();
  const std::vector<bool> idle = idle_rows();
  for (std::size_t b = 0; b < bilinear_.size(); ++b) {
    free_[static_cast<std::size_t>(bilinear_[b])] = idle[idle.size() - bilinear_.size() + b];
  }
  return true;
}

void PeriodMap::accept_image() {
  state_ = image_;
  memory_ = next_memory_;
}

void PeriodMap::move(const VectorXd& ds) {
  state_ += ds;
  memory_ = next_memory_;
  for (Turns& turns : memory_) {
    for (MasingState::Turn& turn : turns) {
      if (turn.slope.size() == ds.size()) turn.displacement += turn.slope.dot(ds);
    }
  }
}

VectorXd PeriodMap::scales() const {
  const Index n = march_.structure().coordinates();
  const VectorXd largest = state_.cwiseAbs().cwiseMax(image_.cwiseAbs());
  const double motion = std::max(largest.head(n).maxCoeff(), largest.segment(n, n).maxCoeff() / omega_);
  const double size = motion > 0.0 ? motion : 1.0;  // without any motion all differences are 0
  VectorXd scales(state_.size());
  scales.head(n).setConstant(size);
  scales.segment(n, n).setConstant(omega_ * size);
  for (Index row = 2 * n; row < scales.size(); ++row) scales[row] = jenkins(row).limit();
  return scales;
}

double PeriodMap::closure() const {
  return (image_ - state_).cwiseQuotient(scales()).cwiseAbs().maxCoeff();
}

std::vector<bool> PeriodMap::idle_rows() const {
  const Index n = march_.structure().coordinates();
  std::vector<bool> idle(static_cast<std::size_t>(state_.size()), false);
  for (Index row = 2 * n; row < state_.size(); ++row) idle[static_cast<std::size_t>(row)] = !jenkins(row).slipped();
  return idle;
}

double PeriodMap::residual_force(Index row) const { return state_[row] + residual_derivative(row).dot(state_) - state_[row]; }

Row PeriodMap::residual_derivative(Index row) const {
  const Index n = march_.structure().coordinates(), joint = bilinear_[static_cast<std::size_t>(row - 2 * n)];
  Row derivative = Row::Zero(state_.size());
  derivative.head(n) = -jenkins(row).stiffness() * march_.structure().incidence.col(joint).transpose();
  derivative[row] = 1.0;
  return derivative;
}

bool PeriodMap::residual_force_free(Index joint) const { return free_[static_cast<std::size_t>(joint)]; }

Eigen::VectorXcd PeriodMap::multipliers() {
  const Index size = state_.size();
  Index corners = 0;
  for (std::size_t j = 0; j < memory_.size(); ++j) {
    if (MasingState* joint = masing(j); joint != nullptr && !memory_[j].empty()) {
      joint->remember(memory_[j], march_.structure().incidence.col(at(j)).dot(state_.head(march_.structure().coordinates())));
      Turns open = joint->corners(march_.structure().incidence.col(at(j)).dot(state_.head(march_.structure().coordinates())));
      memory_[j] = open;
      corners += at(open.size());
    }
  }
  if (corners == 0) return dense::eigenvalues(derivative_);
  place(size + corners);
  if (march_.march(period_) != MarchStatus::reached) return dense::eigenvalues(derivative_);
  MatrixXd all = MatrixXd::Zero(size + corners, size + corners);
  all.topRows(size) = rows_of_state();
  Index next = size;
  const VectorXd q = march_.structure().incidence.transpose() * march_.motion().x;
  for (std::size_t j = 0; j < memory_.size(); ++j) {
    MasingState* joint = masing(j);
    if (joint == nullptr) continue;
    const Turns open = joint->corners(q[at(j)]);
    if (open.size() != memory_[j].size()) return dense::eigenvalues(derivative_);
    for (const auto& corner : open) all.row(next++) = corner.slope;
  }
  return dense::eigenvalues(all);
}

}  // namespace jointid::response
