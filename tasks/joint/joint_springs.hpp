#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ident/result/solution.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::tasks {

/// How tight a spring is beside the others of its direction.
enum class Tightness {
  alike,    ///< at least half of their median
  doubtful, ///< its value is below half of it, its interval is not; or it has no interval
  loose     ///< its whole interval is below half of it
};

/// A spring of a joint as a solution found it: an unknown of the stiffness that pulls pairs of DOFs towards each other.
struct JointSpring {
  std::string unknown;
  std::vector<std::array<frf::Dof, 2>> ends;  ///< several where springs are equal
  double stiffness = 0.0;                     ///< SI
  std::optional<double> half_width;           ///< of its 95 % interval, or the error of linear methods
  double share = 1.0;                         ///< of the median of those of its direction
  std::optional<double> share_half_width;
  std::optional<double> loss_factor;          ///< η = D/K, where the damping has the same spring
  Tightness tightness = Tightness::alike;
};

/// Half of the 95 % interval of an estimate, else its error; empty where it has neither.
std::optional<double> half_width(const ident::Estimate& estimate);

/// The springs of a solution of one band; unknowns of other forms are left out. A spring is found by what its unknown adds to K: rows
/// that add up to nothing, and elements beside the diagonal that are not positive.
std::vector<JointSpring> joint_springs(const restrictions::Restriction& restriction, const ident::Solution& solution);

}  // namespace jointid::tasks
