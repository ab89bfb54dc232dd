#pragma once

#include <functional>
#include <memory>

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// Plans a scene whose method is named.
using Planner = std::function<std::unique_ptr<Plan>(const Scene&)>;

/// [identify] method = "auto": "likelihood" where the variances of all FRFs are known (of the files, of [noise], of repeats), the
/// data allow it and its counted operations take less than a minute on the reference machine (are_expected_within(): no clock and
/// no load of this one decides); else "one", and where that has no equation "likelihood" all the same, or "newton". A weighting,
/// a delta or modal regeneration ask for "one"; a solver, for the method that has it; a start, starts, priors or a bootstrap for
/// "likelihood". Plan::chosen tells which and why.
std::unique_ptr<Plan> plan_automatically(const Scene& scene, const frf::FrfSystem& substructures, const frf::FrfSystem& assembly,
                                         const Planner& planner);

/// For a linear method that was chosen so: the weighting of WB, WBG, WBS and WA whose joint predicts the assembly best. Where
/// FRFs are too many to be kept, or nothing is predicted, it stays WB: they are not read again for it.
void choose_weighting(Plan& plan, const Control& control, RunTime& time);

}  // namespace jointid::ident
