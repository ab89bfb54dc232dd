#pragma once

#include "ident/equations/system_pattern.hpp"
#include "ident/plan/method.hpp"
#include "ident/scene/method_traits.hpp"

namespace jointid::ident {

/// Whether method "likelihood" takes each substructure with its own copy of the motions at its joints: where the scene asks for it
/// (solver = "by-parts"), or leaves the solver open, has more than eight substructures and 150 unknowns or more (any number where it asks
/// which joints are loose), has data for rows by parts, and nothing that these do not go with.
bool goes_by_parts(const Plan& plan);

/// Whether it does after all: with fewer unknowns, where the whole likelihood would take longer than a minute by its cost.
bool is_better_by_parts(const Plan& plan, const Cost& whole);

/// Plans that. Throws InputError for scenes with priors, a bootstrap, several starts, gains or masses, constraints, parts that are
/// coupled first or synthesised FRFs, and data without the motions at the joints.
PlannedMethod plan_by_parts(const Plan& plan, const StartPlanner& plan_start);

/// Which unknowns its groups of substructures touch together; empty for plans of other methods, and below `least` unknowns.
std::optional<SystemPattern> pattern_by_parts(const Plan& plan, std::size_t least);

}  // namespace jointid::ident
