#pragma once

#include <vector>

#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// What the models of a plan did so far, and what they will take for its lines between its DOFs.
std::vector<UsedModel> used_models(const Plan& plan);

}  // namespace jointid::ident
