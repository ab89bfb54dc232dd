#pragma once

#include <vector>

#include "base/statistics.hpp"
#include "study/trial_loop.hpp"
#include "problems/thesis/thesis_tables.hpp"

namespace jointid::problems {

/// What the trials give for one entry of a table.
struct Reproduced {
  Spread ours;
  bool inside = false;  ///< some number that rounds to the print lies between the 5 % and the 95 % quantile
};

/// One per ThesisTable::entries.
std::vector<Reproduced> reproduce(const ThesisTable& table, const study::TrialOptions& options);

}  // namespace jointid::problems
