#pragma once

#include <map>
#include <string>
#include <vector>

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"

namespace jointid::ident {

/// Values (SI, one per column) of the joint with these matrices; those of matrices that are not given are zero. `place` of the
/// scene is named by the InputError (usage) that is thrown when they do not fix an unknown.
std::vector<double> joint_values(const Plan& plan, const std::map<restrictions::Kind, Matrix>& matrices, const std::string& place);

/// Values (SI, one per column) of the joint that the scene assumes: [truth], else [identify] start; matrices that it does not
/// give are zero. Throws InputError (usage) when there is neither, or they do not fix an unknown.
std::vector<double> joint_guess(const Plan& plan);

/// Scaled unknowns of a plan by the estimate of another that it starts from; 0 where that has none.
std::vector<double> started(const Plan& plan, const Plan& start, const Control& control);

/// The number of a candidate coordinate. Throws InputError (usage) when it is none of `coordinates`.
std::size_t find_candidate(const Scene& scene, const Dofs& coordinates, const frf::Dof& dof);

/// Scaled unknowns of a plan from values in SI.
std::vector<double> scaled(const Plan& plan, const std::vector<double>& values);

}  // namespace jointid::ident
