#include "response/orbit/period_map.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::response {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Row = JointState::Row;

PeriodMap::PeriodMap(const PeriodicProblem& problem, const MarchOptions& options)
    : omega_(problem.omega), period_(problem.period()), march_(problem.structure, problem.force(), options) {
  const std::size_t joints = problem.structure.laws.size();
  for (std::size_t j = 0; j < joints; ++j) {
    if (dynamic_cast<JenkinsState*>(march_.joint_states()[j].get()) != nullptr) bilinear_.push_back(at(j));
  }
  memory_.resize(joints);
  next_memory_.resize(joints);
  free_.resize(joints);
  state_ = image_ = VectorXd::Zero(motion_size());
  was_idle_.resize(static_cast<std::size_t>(motion_size()));
  bound_to_slip_.resize(static_cast<std::size_t>(motion_size()));
}

MasingState* PeriodMap::masing(std::size_t joint) const { return dynamic_cast<MasingState*>(march_.joint_states()[joint].get()); }

JenkinsState& PeriodMap::jenkins(Index row) const {
  const Index joint = bilinear_[static_cast<std::size_t>(row - 2 * march_.structure().coordinates())];
  return static_cast<JenkinsState&>(*march_.joint_states()[static_cast<std::size_t>(joint)]);
}

bool PeriodMap::bilinear(Index joint) const { return std::ranges::find(bilinear_, joint) != bilinear_.end(); }

/// Of (x, ẋ, f of the bilinear joints).
Index PeriodMap::motion_size() const { return 2 * march_.structure().coordinates() + at(bilinear_.size()); }

void PeriodMap::start(const VectorXd& x, const VectorXd& v, const VectorXd& f, const std::vector<std::vector<double>>& turns) {
  std::vector<double> all(x.begin(), x.end());
  all.insert(all.end(), v.begin(), v.end());
  for (const Index joint : bilinear_) all.push_back(f[joint]);
  for (std::size_t j = 0; j < memory_.size(); ++j) {
    memory_[j].clear();
    if (masing(j) == nullptr) continue;
    for (const double displacement : turns[j]) memory_[j].push_back({displacement, Row()});
    all.insert(all.end(), turns[j].begin(), turns[j].end());
  }
  state_ = Eigen::Map<const VectorXd>(all.data(), at(all.size()));
}

void PeriodMap::place(Index columns) {
  const JointedStructure& structure = march_.structure();
  const Index n = structure.coordinates();
  VectorXd forces = VectorXd::Zero(structure.joints());
  MatrixXd seed = MatrixXd::Zero(2 * n + structure.joints(), columns);
  if (columns > 0) seed.topLeftCorner(2 * n, 2 * n).setIdentity();
  for (std::size_t b = 0; b < bilinear_.size(); ++b) {
    forces[bilinear_[b]] = state_[2 * n + at(b)];
    if (columns > 0) seed(2 * n + bilinear_[b], 2 * n + at(b)) = 1.0;
  }
  const VectorXd q = structure.incidence.transpose() * state_.head(n);
  Index next = motion_size();
  for (std::size_t j = 0; j < memory_.size(); ++j) {
    march_.joint_states()[j]->follow(columns);
    MasingState* joint = masing(j);
    if (joint == nullptr) continue;
    Turns& turns = memory_[j];
    for (auto& turn : turns) turn.slope = columns > 0 ? Row(Row::Unit(columns, next++)) : Row();
    const auto largest = std::ranges::max_element(turns, {}, [](const auto& turn) { return std::abs(turn.displacement); });
    if (!turns.empty()) joint->remember({largest, turns.end()}, q[at(j)], tangent_of_loop(j));
    joint->forget_turns();
  }
  march_.place(0.0, state_.head(n), state_.segment(n, n), forces);
  march_.follow(seed);
  for (Index row = 2 * n; row < motion_size(); ++row) jenkins(row).watch();
}

namespace {

double range_of(const std::vector<MasingState::Turn>& turns) {
  const auto [low, high] =
      std::ranges::minmax_element(turns, {}, [](const MasingState::Turn& turn) { return turn.displacement; });
  return high->displacement - low->displacement;
}

}  // namespace

std::optional<double> PeriodMap::tangent_of_loop(std::size_t joint) const {
  if (!keeps_ || !free_[joint]) return {};
  return masing(joint)->tangent_at_turn(range_of(memory_[joint]));
}

void PeriodMap::remember_turns() {
  for (std::size_t j = 0; j < memory_.size(); ++j) {
    const MasingState* joint = masing(j);
    if (joint == nullptr) continue;
    next_memory_[j] = memory_[j];
    if (joint->turns().empty()) continue;
    next_memory_[j] = joint->turns();
    free_[j] = joint->keeps_residual_force(range_of(next_memory_[j]));
  }
}

void PeriodMap::collect_image() {
  const Instant motion = march_.motion();
  const Index n = motion.x.size(), moving = motion_size();
  Index size = moving;
  bool same = true;
  for (std::size_t j = 0; j < memory_.size(); ++j) {
    same = same && memory_[j].size() == next_memory_[j].size();
    size += at(memory_[j].size());
  }
  if (!same) size = moving;
  image_.resize(size);
  image_.head(moving) << motion.x, motion.v, motion.f(bilinear_);
  Index next = moving;
  for (std::size_t j = 0; j < memory_.size() && next < size; ++j) {
    for (const MasingState::Turn& turn : next_memory_[j]) image_[next++] = turn.displacement;
  }
  derivative_.resize(0, 0);
  if (march_.slopes().cols() == 0) return;
  derivative_.resize(size, size);
  derivative_.topRows(2 * n) = march_.slopes().topLeftCorner(2 * n, size);
  for (std::size_t b = 0; b < bilinear_.size(); ++b) {
    derivative_.row(2 * n + at(b)) = march_.slopes().row(2 * n + bilinear_[b]).head(size);
  }
  next = moving;
  for (std::size_t j = 0; j < memory_.size() && next < size; ++j) {
    for (const MasingState::Turn& turn : next_memory_[j]) derivative_.row(next++) = turn.slope;
  }
}

bool PeriodMap::run(bool with_derivative) {
  place(with_derivative ? state_.size() : 0);
  const std::size_t before = march_.events();
  if (!march_.march(period_)) return false;
  events_ = march_.events() - before;
  remember_turns();
  collect_image();
  for (Index row = 2 * march_.structure().coordinates(); row < motion_size(); ++row) {
    const Index joint = bilinear_[static_cast<std::size_t>(row - 2 * march_.structure().coordinates())];
    const auto which = static_cast<std::size_t>(row);
    const bool slipped = jenkins(row).slipped();
    free_[static_cast<std::size_t>(joint)] = !slipped;
    if (with_derivative && slipped && was_idle_[which]) bound_to_slip_[which] = true;
    was_idle_[which] = with_derivative && !slipped;
  }
  return true;
}

void PeriodMap::accept_image() { move(image_ - state_.head(image_.size())); }

void PeriodMap::abandon_move() {
  state_ = state_before_;
  image_ = image_before_;
  next_memory_ = memory_before_;
  accept_image();
}

void PeriodMap::move(const VectorXd& ds) {
  state_before_ = state_;
  image_before_ = image_;
  memory_before_ = next_memory_;
  VectorXd moved(motion_size());
  moved = state_.head(moved.size()) + ds.head(moved.size());
  const bool with_memory = image_.size() > moved.size();
  Index next = moved.size();
  const VectorXd remembered = with_memory ? VectorXd(state_ + ds) : VectorXd();
  memory_ = next_memory_;
  std::vector<double> all(moved.begin(), moved.end());
  for (Turns& turns : memory_) {
    for (MasingState::Turn& turn : turns) {
      if (with_memory) turn.displacement = remembered[next++];
      all.push_back(turn.displacement);
    }
  }
  state_ = Eigen::Map<const VectorXd>(all.data(), at(all.size()));
}

VectorXd PeriodMap::scales() const {
  const Index n = march_.structure().coordinates();
  const VectorXd largest = state_.head(2 * n).cwiseAbs().cwiseMax(image_.head(2 * n).cwiseAbs());
  const double motion = std::max(largest.head(n).maxCoeff(), largest.tail(n).maxCoeff() / omega_);
  const double size = motion > 0.0 ? motion : 1.0;  // without any motion all differences are 0
  VectorXd scales = VectorXd::Constant(image_.size(), size);
  scales.segment(n, n).setConstant(omega_ * size);
  for (Index row = 2 * n; row < motion_size(); ++row) scales[row] = jenkins(row).limit();
  return scales;
}

double PeriodMap::closure() const {
  const Index size = motion_size();
  return (image_ - state_.head(image_.size())).head(size).cwiseQuotient(scales().head(size)).cwiseAbs().maxCoeff();
}

std::vector<bool> PeriodMap::idle_rows() const {
  std::vector<bool> idle(static_cast<std::size_t>(image_.size()), false);
  for (Index row = 2 * march_.structure().coordinates(); row < motion_size(); ++row) {
    idle[static_cast<std::size_t>(row)] = !jenkins(row).slipped() && !bound_to_slip_[static_cast<std::size_t>(row)];
  }
  return idle;
}

double PeriodMap::residual_force(Index row) const { return residual_derivative(row).dot(state_.head(image_.size())); }

Row PeriodMap::residual_derivative(Index row) const {
  const Index n = march_.structure().coordinates(), joint = bilinear_[static_cast<std::size_t>(row - 2 * n)];
  Row derivative = Row::Zero(image_.size());
  derivative.head(n) = -jenkins(row).stiffness() * march_.structure().incidence.col(joint).transpose();
  derivative[row] = 1.0;
  return derivative;
}

bool PeriodMap::residual_force_free(Index joint) const { return free_[static_cast<std::size_t>(joint)]; }

}  // namespace jointid::response
