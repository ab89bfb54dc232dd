#pragma once

#include <string>

#include "ident/result/solution.hpp"

namespace jointid::report {

/// The solution for reading: what was done, joint matrices, unknowns, fit, quality, run time.
/// `units`: those of the values, as units_text().
std::string solution_text(const ident::Solution& solution, const std::string& title, const std::string& units = "SI units");

/// The unknowns as CSV: name, value, unit, std_error, ci95_low, ci95_high, determined; empty where not computed.
std::string unknowns_csv(const ident::Solution& solution);

}  // namespace jointid::report
