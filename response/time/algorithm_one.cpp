#include "response/time/algorithm_one.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "dense/cholesky.hpp"
#include "dense/real_lu.hpp"

namespace jointid::response {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

AlgorithmOne::AlgorithmOne(JointedStructure structure, ForceHistory force, double delta, const std::vector<NormalLoad>& loads,
                           StepIteration iteration)
    : structure_(std::move(structure)), force_(std::move(force)), delta_(delta), iteration_(iteration) {
  check(structure_, force_);
  check_step(delta);
  const MatrixStructure& m = structure_.matrices;
  const auto factor = dense::cholesky(4.0 / (delta * delta) * m.mass + 2.0 / delta * m.damping + m.stiffness);
  if (!factor) {
    throw InputError({.kind = ErrorKind::data,
                      .file = {},
                      .place = "time step " + std::to_string(delta) + " s",
                      .problem = "4M/Δ² + 2C/Δ + K is not positive definite",
                      .remedy = "look for negative damping or stiffness"});
  }
  lower_ = *factor;
  columns_ = structure_.incidence;
  dense::solve_lower(lower_, columns_);
  dense::solve_lower_transposed(lower_, columns_);
  flexibility_ = structure_.incidence.transpose() * columns_;
  initial_stiffness_ = structure_.initial_stiffness();
  paths_ = joint_paths(structure_, loads);
  const VectorXd rest = VectorXd::Zero(structure_.coordinates());
  motion_ = {0.0, rest, rest, VectorXd::Zero(structure_.joints())};
  acceleration_ = dense::solve_positive(m.mass, force_.value(0.0));
}

AlgorithmOne::Joints AlgorithmOne::joints_at(const VectorXd& q) const {
  Joints joints{VectorXd(q.size()), VectorXd(q.size())};
  for (Index j = 0; j < q.size(); ++j) {
    const friction::Response at = paths_[static_cast<std::size_t>(j)].response(q[j]);
    joints.force[j] = at.force;
    joints.tangent[j] = at.tangent;
  }
  return joints;
}

/// Along d = −G dλ the slope gᵀd of the convex function rises from below 0; a full step is shortened when it ends far above.
double AlgorithmOne::step_length(const VectorXd& q, const VectorXd& lambda, const VectorXd& dlambda) const {
  const VectorXd d = -flexibility_ * dlambda;
  const auto slope = [&](double t) { return (joints_at(q + t * d).force - lambda - t * dlambda).dot(d); };
  const double first = slope(0.0);
  double low = 0.0, high = 1.0, at_low = first, at_high = slope(1.0), t = 1.0;
  for (int i = 0; i < 40 && at_high > 0.5 * std::abs(first); ++i) {
    t = i % 2 == 0 ? low + (high - low) * at_low / (at_low - at_high) : 0.5 * (low + high);
    const double now = slope(t);
    if (std::abs(now) <= 0.5 * std::abs(first)) break;
    if (now < 0.0) {
      low = t;
      at_low = now;
    } else {
      high = t;
      at_high = now;
    }
  }
  return t;
}

/// λ = f(q), q = q_lin − Gλ.
VectorXd AlgorithmOne::solve_joints(const VectorXd& q_linear) {
  VectorXd lambda = motion_.f, q = q_linear - flexibility_ * lambda;
  std::size_t solutions = 0;
  double left = 0.0;
  for (; solutions < 200;) {
    const Joints joints = joints_at(q);
    const VectorXd g = joints.force - lambda;
    const double scale = std::max(joints.force.cwiseAbs().maxCoeff(), lambda.cwiseAbs().maxCoeff());
    left = scale > 0.0 ? g.cwiseAbs().maxCoeff() / scale : 0.0;
    // Rounding of q alone changes the forces by as much as T′(0) ε |q|.
    const double rounding =
        4e-16 * initial_stiffness_.cwiseMax(joints.tangent).cwiseProduct(q.cwiseAbs().cwiseMax(q_linear.cwiseAbs())).maxCoeff();
    if (left <= 1e-13 || left * scale <= rounding) break;
    const MatrixXd jacobian = MatrixXd::Identity(q.size(), q.size()) + joints.tangent.asDiagonal() * flexibility_;
    const VectorXd dlambda = dense::RealLu(jacobian).solve(g);
    ++solutions;
    lambda += step_length(q, lambda, dlambda) * dlambda;
    const VectorXd next = q_linear - flexibility_ * lambda;
    if (next == q) break;  // as near as numbers come
    q = next;
  }
  solutions_ += solutions;
  most_solutions_ = std::max(most_solutions_, solutions);
  residual_ = std::max(residual_, left);
  return lambda;
}

VectorXd AlgorithmOne::iterate_joints(const VectorXd& q_linear) {
  VectorXd lambda = motion_.f, q = q_linear - flexibility_ * lambda;
  for (int i = 0; i < 200; ++i) {
    ++solutions_;
    most_solutions_ = std::max(most_solutions_, static_cast<std::size_t>(i) + 1);
    lambda = joints_at(q).force;
    const VectorXd next = q_linear - flexibility_ * lambda;
    const bool near = (next - q).cwiseAbs().maxCoeff() <= 1e-10 * next.cwiseAbs().maxCoeff();
    q = next;
    if (near) return lambda;
  }
  diverged_ = true;
  return lambda;
}

void AlgorithmOne::step() {
  const MatrixStructure& m = structure_.matrices;
  const double time = static_cast<double>(++steps_) * delta_;
  const VectorXd &x = motion_.x, &v = motion_.v;
  VectorXd linear = force_.value(time) + m.mass * (4.0 / (delta_ * delta_) * x + 4.0 / delta_ * v + acceleration_) +
                    m.damping * (2.0 / delta_ * x + v);
  dense::solve_lower(lower_, linear);
  dense::solve_lower_transposed(lower_, linear);
  for (JointPath& path : paths_) path.set_time(time);
  const VectorXd free = structure_.incidence.transpose() * linear;
  VectorXd lambda;
  if (structure_.joints() > 0) lambda = iteration_ == StepIteration::direct ? iterate_joints(free) : solve_joints(free);
  const VectorXd next = linear - columns_ * lambda, q = structure_.incidence.transpose() * next;
  const VectorXd moved = next - x, speed = 2.0 / delta_ * moved - v;
  acceleration_ = 4.0 / (delta_ * delta_) * moved - 4.0 / delta_ * v - acceleration_;
  motion_ = {time, next, speed, lambda};
  for (Index j = 0; j < q.size(); ++j) motion_.f[j] = paths_[static_cast<std::size_t>(j)].advance(q[j]).force;
}

}  // namespace jointid::response
