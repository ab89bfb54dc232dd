#pragma once

#include <string>

#include "report/text/display.hpp"
#include "tasks/solution_details.hpp"

namespace jointid::report {

/// The page of a solved plan. `details`: tasks::solution_details(), of most_frfs FRFs. Above all others stand the status, the values
/// with their intervals and the FRF that is met worst, as measured and as synthesised.
std::string solve_report(const ident::Plan& plan, const ident::Solution& solution, const tasks::SolutionDetails& details,
                         const Display& display = {});

}  // namespace jointid::report
