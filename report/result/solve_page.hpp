#pragma once

#include <string>

#include "report/text/display.hpp"
#include "tasks/regenerate.hpp"

namespace jointid::report {

/// The page of a solved plan. Computes what only a report shows: regenerated FRFs, and figures of merit line by line when
/// the scene tells the truth. `first`: an FRF that has to be among those shown. Above all others stand
/// the status, the values with their intervals and the FRF that is met worst, as measured and as synthesised.
std::string solve_report(ident::Plan& plan, const ident::Solution& solution, const std::optional<tasks::FrfEntry>& first,
                         const ident::Control& control, const Display& display = {});

}  // namespace jointid::report
