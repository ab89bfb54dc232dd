#pragma once

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// Opens the scene's files (headers only) and plans. Throws InputError for DOFs that no file has, equations that the data do
/// not allow, ranges without lines, and methods or solvers that cannot do what the scene asks.
/// FRFs are read here only when the scene asks for resonances to be found, or for FRFs to be regenerated.
std::unique_ptr<Plan> make_plan(const Scene& scene);

/// The same on sources that are open already, for sets in memory.
std::unique_ptr<Plan> make_plan(const Scene& scene, std::shared_ptr<frf::FrfSystem> substructures,
                                std::shared_ptr<frf::FrfSystem> assembly);

/// The same on FRFs in memory; throws InputError for sets whose sizes do not agree (frf::validate()).
std::unique_ptr<Plan> make_plan(const Scene& scene, std::vector<frf::FrfSet> substructures, std::vector<frf::FrfSet> assembly);

/// The same in every process of a team, for all to solve together (Control::shares); what method = "auto" chooses is the leader's
/// choice. An error is told once (start_together()).
std::unique_ptr<Plan> make_plan(const Scene& scene, Team& team);

/// Carries out a plan: reads what it names line by line, assembles, solves, predicts and judges. Throws InputError when the
/// data break their promises; a numerical outcome is Solution::status. Processes that share the lines all get the same solution, to
/// the last bit; where the method cannot share them InputError says why.
Solution solve(Plan& plan, const Control& control = {});

}  // namespace jointid::ident
