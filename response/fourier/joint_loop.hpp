#pragma once

#include <Eigen/Core>
#include <vector>

#include "friction/path/masing_path.hpp"
#include "response/fourier/motion.hpp"
#include "response/joint/joint.hpp"

namespace jointid::response {

/// A friction element at θ = 0 of a periodic motion without residual force, and what it remembers.
struct PeriodicMemory {
  std::vector<double> turns;  ///< q where the motion turned in the period before, the largest |q| first of those that count
  double force = 0.0;
};

/// Empty turns where the motion does not turn.
PeriodicMemory periodic_memory(const friction::Element& element, const Motion& motion);

/// The loop of a joint over a period: q and the force at `points` even times from θ = 0 (the first is not repeated at the end).
struct JointLoop {
  Eigen::VectorXd displacement, force;
};
JointLoop joint_loop(const Joint& joint, const Motion& motion, double omega, int points);

}  // namespace jointid::response
