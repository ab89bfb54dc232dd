#pragma once

#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// A Plan but for its method, on sources that are open: restriction, coordinates, lines, columns, ω₀ and constraints, and the
/// equations where the method is not the one to choose them. Throws as make_plan().
std::unique_ptr<Plan> prepare_plan(const Scene& scene, std::shared_ptr<frf::FrfSystem> substructures,
                                   std::shared_ptr<frf::FrfSystem> assembly);

/// Gives a plan what its method decided, and tells what of its data the scene does not need and what is to be said of them.
void complete_plan(PlannedMethod decided, Plan& plan);

}  // namespace jointid::ident
