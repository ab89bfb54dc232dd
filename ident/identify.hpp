#pragma once

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// Opens the scene's files (headers only) and plans. Throws InputError for DOFs that no file has, equations that the data do not
/// allow, ranges without lines, and methods or solvers that do not support the scene. FRFs are read here only if the scene asks
/// for resonances, or for synthesised FRFs.
std::unique_ptr<Plan> make_plan(const Scene& scene);

/// The same on open sources, for sets in memory.
std::unique_ptr<Plan> make_plan(const Scene& scene, std::shared_ptr<frf::FrfSystem> substructures,
                                std::shared_ptr<frf::FrfSystem> assembly);

/// The same on FRFs in memory; throws InputError for sets whose sizes do not agree (frf::validate()).
std::unique_ptr<Plan> make_plan(const Scene& scene, std::vector<frf::FrfSet> substructures, std::vector<frf::FrfSet> assembly);

/// The same in every process of a team, for a joint solution (Control::shares). For method = "auto" the leader chooses. An error
/// is reported once (start_together()).
std::unique_ptr<Plan> make_plan(const Scene& scene, Team& team);

/// Carries out a plan: reads its data line by line, assembles, solves, predicts and judges. Throws InputError if the data
/// contradict their headers; a numerical outcome is Solution::status. Processes that share the lines all get the same solution,
/// to the last bit. A method that cannot share them throws InputError.
Solution solve(Plan& plan, const Control& control = {});

}  // namespace jointid::ident
