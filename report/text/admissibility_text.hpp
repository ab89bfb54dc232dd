#pragma once

#include <string>

#include "report/text/table.hpp"
#include "ident/result/admissibility.hpp"
#include "ident/result/solution.hpp"

namespace jointid::report {

/// The constraints, one row each: how many of their equations hold, and what that costs.
Table constraints_table(const ident::Admissibility& found);

/// "χ² rises by 12.3, 3 equations hold".
std::string constraints_sum(const ident::Admissibility& found);

/// The section "constraints" of a solution; empty for scenes without.
std::string constraints_text(const ident::Solution& solution);

/// The joints most probably loose, ten at most; empty where the scene does not ask for them.
std::string loose_text(const ident::Solution& solution);

}  // namespace jointid::report
