#include "response/time/exact_march.hpp"

#include <algorithm>
#include <cmath>

#include "response/time/virgin_joint.hpp"

namespace jointid::response {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Instant MarchStep::motion(double sigma) const {
  const VectorXd z = sum_series(series, sigma);
  Instant motion{start + sigma * length, z.head(coordinates), z.segment(coordinates, coordinates),
                z.segment(2 * coordinates, joints)};
  for (Index c = 0; c < curved_forces.rows(); ++c) {
    double force = 0.0;
    for (Index p = curved_forces.cols(); p-- > 0;) force = force * sigma + curved_forces(c, p);
    motion.f[curved[static_cast<std::size_t>(c)]] = force;
  }
  return motion;
}

ExactMarch::ExactMarch(JointedStructure structure, ForceHistory force, MarchOptions options)
    : structure_(std::move(structure)), force_(std::move(force)), options_(options) {
  check(structure_, force_);
  for (const auto& law : structure_.laws) states_.push_back(virgin_joint(*law));
  const VectorXd rest = VectorXd::Zero(structure_.coordinates());
  place(0.0, rest, rest, VectorXd::Zero(structure_.joints()));
}

void ExactMarch::place(double time, const VectorXd& x, const VectorXd& v, const VectorXd& f) {
  time_ = time;
  z_.resize(2 * x.size() + f.size() + force_.load().cols());
  z_ << x, v, f, force_.state(time);
  trial_ = friction::infinity;
  events_here_ = 0;
  choose_directions();
}

/// By the signs of q̇; at rest by the motion a moment later.
void ExactMarch::choose_directions() {
  const Index n = structure_.coordinates();
  const VectorXd q = structure_.incidence.transpose() * z_.head(n);
  VectorXd velocity = structure_.incidence.transpose() * z_.segment(n, n);
  std::vector<std::optional<double>> tangents;
  for (std::size_t j = 0; j < states_.size(); ++j) tangents.push_back(states_[j]->response(q[at(j)]).tangent);
  std::optional<LinearFlow> soon;
  for (Index j = 0; j < q.size(); ++j) {
    if (velocity[j] != 0.0) continue;
    if (!soon) soon.emplace(structure_, force_, tangents, options_.longest_step);
    JointCourse course(*soon, z_, states_);
    course.solve(0.05 * soon->longest_step());
    velocity[j] = course.velocity()[j];
  }
  for (Index j = 0; j < q.size(); ++j) {
    JointState& state = *states_[static_cast<std::size_t>(j)];
    const double force = z_[2 * n + j];
    state.begin(q[j], velocity[j] < 0.0 ? -1 : 1, force);
    z_[2 * n + j] = state.response(q[j]).force;
  }
}

LinearFlow& ExactMarch::flow() {
  std::vector<double> key;
  std::vector<std::optional<double>> stiffness;
  for (const auto& state : states_) {
    stiffness.push_back(state->piece().stiffness);
    key.push_back(stiffness.back().value_or(-1.0));
  }
  const auto found = flows_.find(key);
  if (found != flows_.end()) return found->second;
  return flows_.emplace(key, LinearFlow(structure_, force_, stiffness, options_.longest_step)).first->second;
}

Instant ExactMarch::motion() const {
  const Index n = structure_.coordinates();
  return {time_, z_.head(n), z_.segment(n, n), z_.segment(2 * n, structure_.joints())};
}

bool ExactMarch::march(double until, const std::function<void(const MarchStep&)>& see) {
  const double least = (until - time_) / flow().longest_step();
  if (least > most_steps) return false;
  const std::size_t last = steps_ + static_cast<std::size_t>(spare_steps + 20.0 * std::max(least, 0.0));
  while (time_ < until) {
    if (steps_ >= last) return false;
    const double change = force_.next_change(time_), limit = std::min(until, change);
    if (!step(limit, see)) return false;
    if (time_ == change) z_.tail(force_.load().cols()) = force_.state(time_);
  }
  return true;
}

/// The length of the step: up to the limit, the first event, or as far as the forces are polynomials.
bool ExactMarch::find_length(const LinearFlow& flow, JointCourse& course, double limit, Event& event) {
  const bool curved = !flow.curved().empty();
  double h = flow.longest_step();
  if (curved) {
    while (h > trial_) h *= 0.5;
  }
  for (int halving = 0; halving < 60; ++halving, h *= 0.5) {
    const double left = limit - time_, length = h < left * (1.0 - 1e-9) ? h : left;
    event = {};
    if (!course.solve(length)) continue;
    event = first_event(course, length);
    if (!course.solve(event.joint >= 0 ? event.at : length)) continue;
    if (!curved || course.mismatch() <= options_.mismatch) {
      trial_ = 2.0 * h;
      return true;
    }
  }
  return false;
}

void ExactMarch::go(LinearFlow& flow, const JointCourse& course) {
  const Index n = structure_.coordinates();
  const double h = course.length();
  if (flow.remembers(h) || slopes_.cols() > 0) {
    const StepMatrices& step = flow.step_matrices(h);
    if (slopes_.cols() > 0) follow_slopes(flow, course, step);
    z_ = (step.transition * z_ + step.input * course.node_forces()).eval();
  } else {
    z_ = sum_series(flow.series(z_, h, course.force_series()), 1.0);
  }
  for (const Index j : flow.curved()) z_[2 * n + j] = states_[static_cast<std::size_t>(j)]->response(course.q()[j]).force;
}

bool ExactMarch::step(double limit, const std::function<void(const MarchStep&)>& see) {
  LinearFlow& smooth = flow();
  JointCourse course(smooth, z_, states_);
  Event event;
  if (!find_length(smooth, course, limit, event)) return false;
  const double h = course.length(), from = time_;
  if (see && h > 0.0) {
    const MatrixXd forces = course.force_series();
    see({from, h, structure_.coordinates(), structure_.joints(), smooth.series(z_, h, forces), smooth.curved(), forces});
  }
  go(smooth, course);
  const bool arrives = event.joint < 0 && h == limit - from;
  time_ = arrives ? limit : from + h;
  z_.tail(force_.load().cols()) = force_.state(std::min(time_, std::nextafter(limit, from)));
  ++steps_;
  events_here_ = h > 1e-12 * smooth.longest_step() ? 0 : events_here_ + 1;
  if (event.joint >= 0) pass(event);
  return events_here_ < 100 && z_.allFinite();
}

void ExactMarch::pass(const Event& event) {
  const Index n = structure_.coordinates(), j = event.joint;
  JointState& state = *states_[static_cast<std::size_t>(j)];
  double q = structure_.incidence.col(j).dot(z_.head(n));
  JointState::Row dq, df;
  if (slopes_.cols() > 0) {
    dq = structure_.incidence.col(j).transpose() * slopes_.topRows(n);
    df = slopes_.row(2 * n + j);
  }
  if (event.turns) {
    z_[2 * n + j] = state.turn(q, dq, df);
  } else {
    const Piece piece = state.piece();
    q = std::abs(q - piece.lower) < std::abs(q - piece.upper) ? piece.lower : piece.upper;
    z_[2 * n + j] = state.reach(q, dq, df);
  }
  if (slopes_.cols() > 0) slopes_.row(2 * n + j) = df;
  ++events_;
  trial_ = std::min(trial_, flow().longest_step() / 8.0);
}

}  // namespace jointid::response
