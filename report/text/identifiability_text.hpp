#pragma once

#include <string>

#include "report/text/table.hpp"
#include "ident/result/identifiability.hpp"
#include "ident/result/solution.hpp"

namespace jointid::report {

/// "Cramér–Rao bound", "parametric bootstrap" or "–".
std::string interval_words(ident::IntervalKind kind);

/// The combinations of unknowns that the data fix worst, one row each.
Table weakest_table(const std::vector<ident::WeakCombination>& weakest);

/// Rows of names and numbers: largest error, how far the joint can be seen.
std::vector<std::pair<std::string, std::string>> visibility_rows(const ident::Solution& solution);

/// The section "identifiability" of a solution; empty for methods that know nothing of it.
std::string identifiability_text(const ident::Solution& solution);

}  // namespace jointid::report
