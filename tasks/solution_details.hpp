#pragma once

#include "ident/result/solution.hpp"
#include "tasks/convergence.hpp"
#include "tasks/entry_errors.hpp"

namespace jointid::tasks {

/// Choice of the assembly FRFs that a report synthesises.
struct DetailChoice {
  std::optional<FrfEntry> first{};   ///< one that is always included
  std::size_t frfs = 16, worst = 4;  ///< their number; the `worst` have the largest errors, the others spread over the structure
};

/// Further results of a report beside a solution.
struct SolutionDetails {
  EntryErrors errors;                  ///< of all assembly FRFs; empty without an estimate
  Regenerated regenerated;             ///< the synthesised FRFs to draw, receptances, m/N
  bool all_used = true;                ///< all lines of them were used in the identification
  std::vector<LineQuality> quality{};  ///< figures of merit over the number of lines; empty if the scene has no truth
  UnknownsByIteration iterations{};    ///< of IterationLog, to be set by who solved; empty of methods that do not iterate
};

/// Reads the assembly FRFs of a solved plan and synthesises them from the substructures and the identified joint. If the scene
/// has the truth, it solves again with fewer lines; the longer a solution takes, the fewer numbers of lines it tries. Throws
/// InputError, and Interrupted.
SolutionDetails solution_details(const ident::Plan& plan, const ident::Solution& solution, const DetailChoice& choice = {},
                                 const ident::Control& control = {});

/// Marks the best estimate of an interrupted run (ident::Control::so_far) as not converged, with a message.
void mark_interrupted(ident::Solution& best);

/// Indices of the finite values in `errors`, largest first.
std::vector<std::size_t> worst_first(const std::vector<double>& errors);

}  // namespace jointid::tasks
