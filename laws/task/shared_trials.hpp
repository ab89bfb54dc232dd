#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "ident/team/team.hpp"
#include "laws/task/law_trial.hpp"

namespace jointid::laws {

/// Makes a trial; called by several threads at once.
using MakeTrial = std::function<LawTrial(std::size_t trial)>;

/// The trials of a study, of `values` values each, that are not known yet, made by the processes of a team in turns; in the
/// leader all of them, in the order of their numbers, and nothing in the others. Throws what making or telling one throws,
/// Interrupted, and InputError when another process fails.
std::optional<std::vector<LawTrial>> trials_made_together(const MakeTrial& make, std::size_t values,
                                                          const LawStudyOptions& options, ident::Team& team);

}  // namespace jointid::laws
