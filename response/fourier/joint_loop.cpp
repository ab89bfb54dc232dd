#include "response/fourier/joint_loop.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jointid::response {
namespace {

constexpr double period = 2.0 * std::numbers::pi;

/// θ of the reversals of a period, ascending from that of the largest |q| in [0, 2π); the last ones may lie behind 2π.
std::vector<double> turns_from_largest(const Motion& motion) {
  std::vector<double> turns = motion.reversals(0.0, period);
  const auto largest = std::ranges::max_element(turns, {}, [&](double theta) { return std::abs(motion.value(theta)); });
  std::rotate(turns.begin(), largest, turns.end());
  for (double& theta : turns) {
    if (theta < turns.front()) theta += period;
  }
  return turns;
}

}  // namespace

PeriodicMemory periodic_memory(const friction::Element& element, const Motion& motion) {
  PeriodicMemory memory;
  friction::MasingPath path(element);
  for (const double theta : turns_from_largest(motion)) {
    if (theta > period) break;
    memory.turns.push_back(motion.value(theta));
    path.advance(memory.turns.back());
  }
  memory.force = path.advance(motion.value(0.0)).force;
  return memory;
}

JointLoop joint_loop(const Joint& joint, const Motion& motion, double omega, int points) {
  JointLoop loop = {Eigen::VectorXd(points), Eigen::VectorXd::Zero(points)};
  const auto theta_of = [&](int i) { return period * i / points; };
  for (int i = 0; i < points; ++i) {
    const double q = motion.value(theta_of(i)), speed = omega * motion.slopes(theta_of(i)).first;
    loop.displacement(i) = q;
    loop.force(i) = joint.stiffness * q + joint.damping * speed + joint.cubic * q * q * q;
  }
  if (!joint.friction) return loop;
  friction::MasingPath path(*joint.friction);
  const std::vector<double> turns = turns_from_largest(motion);
  if (turns.empty()) {  // it does not move, or has a mean only: MasingFourier takes the tangent T′(0)
    loop.force += joint.friction->response(0.0).tangent * loop.displacement;
    return loop;
  }
  int next = static_cast<int>(std::ceil(turns.front() / period * points));
  const int last = next + points;
  for (std::size_t k = 0; k <= turns.size(); ++k) {
    const double until = k < turns.size() ? turns[k] : turns.front() + period;
    for (; next < last && theta_of(next) < until; ++next)
      loop.force(next % points) += path.advance(loop.displacement(next % points)).force;
    path.advance(motion.value(until));
  }
  for (; next < last; ++next) loop.force(next % points) += path.advance(loop.displacement(next % points)).force;
  return loop;
}

}  // namespace jointid::response
