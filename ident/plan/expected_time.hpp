#pragma once

#include <array>

#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// Seconds that the iterations of a plan and their intervals take: its counted operations at the pace of the reference machine
/// (docs/cost.md), on so many threads (0: all cores of this machine). 0 where nothing iterates. Nothing is measured, so that the
/// same plan is told the same time on every machine and under any load.
double expected_seconds(const Cost& cost, std::size_t threads = 0);

/// Where the time of a run lies about expected_seconds(), an experience (docs/cost.md): with H_nn alone the starts that do not lead to the
/// joint take most of it, and the sizes of a scene do not tell how many these are.
std::array<double, 2> expected_range_s(const Plan& plan, std::size_t threads = 0);

/// Whether that is less than `seconds` on the two cores of the reference machine.
bool are_expected_within(double seconds, const Cost& cost);

/// The operations that one core of the reference machine does in a second, in dense matrices of this size.
double reference_pace(std::size_t matrix, bool complex);

}  // namespace jointid::ident
