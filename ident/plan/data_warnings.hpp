#pragma once

#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// Throws InputError (usage) when a part whose DOFs the assembly has is not touched by the joint: the joint's DOFs are then all on
/// one side, and the joint would hold that side to ground.
void require_both_sides(const Plan& plan);

/// For a plan's warnings and notes, one sentence each.
struct DataDoubts {
  std::vector<std::string> warnings, notes;
};

/// What is taken on trust from the headers of the files: DOFs without counterpart, axes that differ, one line for all unknowns, what
/// a reader doubts.
DataDoubts doubts_of_data(const Plan& plan);

}  // namespace jointid::ident
