#pragma once

#include "ident/plan/plan.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// A share of its nominal stiffness that a joint has, and its standard deviation.
struct NominalShare {
  double share = 1.0;
  double deviation = 0.0;  ///< 0: not known
};

/// Per joint the probability that it is loose. A joint that is not has a share from a normal distribution about the median of all
/// (five joints and more; else about 1), a loose one any share between 0 and that, each with its own error. Most joints are taken
/// to be sound: how far sound joints scatter is told by the median distance from the median, how many are loose by the data (EM,
/// at most half).
std::vector<double> looseness(const std::vector<NominalShare>& shares);

/// Fills Solution::loose of a scene with `loose`, the most probable first and of these the loosest.
void find_loose_joints(const Plan& plan, Solution& out);

}  // namespace jointid::ident
