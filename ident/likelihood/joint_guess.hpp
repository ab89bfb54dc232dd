#pragma once

#include "ident/plan.hpp"

namespace jointid::ident {

/// Values (SI, one per column) of the joint that the scene assumes: [truth], else [identify] start; matrices that it does not
/// give are zero. Throws InputError (usage) when there is neither, or they do not fix an unknown.
std::vector<double> joint_guess(const Plan& plan);

/// The number of a candidate coordinate. Throws InputError (usage) when it is none of `coordinates`.
std::size_t find_candidate(const Scene& scene, const Dofs& coordinates, const frf::Dof& dof);

}  // namespace jointid::ident
