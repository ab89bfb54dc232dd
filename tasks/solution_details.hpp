#pragma once

#include "ident/result/solution.hpp"
#include "tasks/convergence.hpp"
#include "tasks/entry_errors.hpp"

namespace jointid::tasks {

/// Which FRFs of the assembly are regenerated for a report.
struct DetailChoice {
  std::optional<FrfEntry> first{};   ///< one that has to be among them
  std::size_t frfs = 16, worst = 4;  ///< as many; of them those that are met worst, the others spread over the structure
};

/// What a report tells beside a solution.
struct SolutionDetails {
  EntryErrors errors;                  ///< of all assembly FRFs; empty without an estimate
  Regenerated regenerated;             ///< the FRFs that are drawn, receptances, m/N
  bool all_used = true;                ///< all lines of them served the identification
  std::vector<LineQuality> quality{};  ///< figures of merit over the number of lines; empty where the scene tells no truth
};

/// Reads the assembly FRFs of a solved plan and regenerates them from the substructures and the identified joint; where the scene
/// tells the truth, solves again with fewer lines, the fewer numbers of lines the longer a solution takes. Throws InputError, and
/// Interrupted.
SolutionDetails solution_details(const ident::Plan& plan, const ident::Solution& solution, const DetailChoice& choice = {},
                                 const ident::Control& control = {});

/// Marks the best estimate of a run that was interrupted (ident::Control::so_far): not converged, with a message that says so.
void mark_interrupted(ident::Solution& best);

/// Places in `errors` of the values that are there (no NaN), worst first.
std::vector<std::size_t> worst_first(const std::vector<double>& errors);

}  // namespace jointid::tasks
