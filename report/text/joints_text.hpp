#pragma once

#include <string>

#include "ident/result/solution.hpp"

namespace jointid::report {

/// More unknowns than this, of several joints, are shown joint by joint.
inline constexpr std::size_t most_unknowns_in_full = 200;

/// Whether a solution is shown joint by joint in place of all its unknowns and of matrices over all joint coordinates.
bool is_shown_by_joint(const ident::Solution& solution);

/// A line for each joint: its largest stiffness as number and bar, damping, the worst error and what the data do not determine; of many
/// joints the worst.
std::string joints_text(const ident::Solution& solution);

}  // namespace jointid::report
