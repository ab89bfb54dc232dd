#pragma once

#include <string>
#include <vector>

#include "problems/case/identification_problem.hpp"
#include "problems/case/problem_info.hpp"
#include "problems/structure/many_joints.hpp"

namespace jointid::problems {

/// Chains, a frame and a star of beams on 40 to 500 joints: motion at all coordinates and a few shakers, Method One by parts.
std::vector<ProblemInfo> list_many_joints();

bool is_many_joints(const std::string& name);

/// "chain-50", "chain-500", "frame-40" or "star-50".
ManyJoints many_joints(const std::string& name);
Problem make_many_joints(const std::string& name);

/// The problem of any such structure. `all_elements`: 4 × 4 symmetric matrices with 20 unknowns in a joint in place of the relative ones.
Problem many_joints_problem(const ManyJoints& structure, const ProblemInfo& info, bool all_elements);

}  // namespace jointid::problems
