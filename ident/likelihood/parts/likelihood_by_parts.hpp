#pragma once

#include "ident/plan/method.hpp"
#include "ident/scene/method_traits.hpp"

namespace jointid::ident {

/// Whether method "likelihood" takes each substructure with its own copy of the motions at its joints: where the scene asks for it
/// (solver = "by-parts"), or leaves the solver open, has more than eight substructures and 150 unknowns or more (any number where it asks
/// which joints are loose), has data for rows by parts, and nothing that these do not go with.
bool goes_by_parts(const Plan& plan);

/// Plans that. Throws InputError for scenes with priors, a bootstrap, several starts, gains or masses, constraints, parts that are
/// coupled first or synthesised FRFs, and data without the motions at the joints.
PlannedMethod plan_by_parts(const Plan& plan, const StartPlanner& plan_start);

}  // namespace jointid::ident
