#pragma once

#include "ident/plan/method.hpp"

namespace jointid::ident {

/// Plans a scene whose frequencies_are_data(): the joints that explain the lowest elastic eigenfrequencies of an assembly of models. No FRF
/// is read. Throws InputError for parts that are no matrices, joints with other unknowns than a share of their stiffness, and constraints.
PlannedMethod plan_loose_by_frequencies(const Plan& plan);

}  // namespace jointid::ident
