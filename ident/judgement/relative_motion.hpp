#pragma once

#include <string>
#include <vector>

#include "ident/plan/plan.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// The same direction on two sides of a joint.
struct RelativeMotion {
  std::string joint;
  frf::Dof a, b;
  double over_error = 0.0;  ///< |x_a − x_b| over its standard error, median over lines and references of the assembly
};

/// Of all joints whose two sides the assembly's files have; empty where they do not state its errors. Rows by parts see a stiff joint
/// through this difference alone, and no condition number shows what it loses there.
std::vector<RelativeMotion> relative_motions(const Plan& plan);

/// A warning of those that are not above their errors.
void tell_relative_motions(const Plan& plan, Solution& out);

}  // namespace jointid::ident
