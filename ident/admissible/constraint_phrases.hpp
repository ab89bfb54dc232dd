#pragma once

#include <string>
#include <vector>

#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// What the scene requires of the joint, one phrase per tie and inequality; empty where it has no constraints.
std::vector<std::string> constraint_phrases(const Plan& plan);

}  // namespace jointid::ident
