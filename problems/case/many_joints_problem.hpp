#pragma once

#include <map>
#include <string>
#include <vector>

#include "problems/case/identification_problem.hpp"
#include "problems/case/problem_info.hpp"
#include "problems/structure/many_joints.hpp"

namespace jointid::problems {

/// Chains, a frame and a star of beams on 40 to 500 joints: motion at all coordinates and a few shakers, Method One by parts.
std::vector<ProblemInfo> list_many_joints();

bool is_many_joints(const std::string& name);

/// "chain-50", "chain-500", "frame-40", "star-50", or "loose-3" before joints came loose.
ManyJoints many_joints(const std::string& name);
Problem make_many_joints(const std::string& name);

/// The problem of any such structure. `all_elements`: 4 × 4 symmetric matrices with 20 unknowns in a joint in place of the relative ones.
Problem many_joints_problem(const ManyJoints& structure, const ProblemInfo& info, bool all_elements);

/// Which joints of the structure are loose, where each lacks a share of its nominal stiffness (by its number) and the damping stays: the
/// scene has `loose` and the nominal joints by numbers. Of joints with coordinates of their own.
Problem loose_joints_problem(const ManyJoints& nominal, const std::map<std::size_t, double>& lost, const ProblemInfo& info);

}  // namespace jointid::problems
