#pragma once

#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// Seconds that the iterations of a plan and their intervals take: its counted operations at the pace of the reference machine
/// (docs/cost.md), on so many threads (0: all cores of this machine). 0 where nothing iterates. Nothing is measured, so that the
/// same plan is told the same time on every machine and under any load.
double expected_seconds(const Cost& cost, std::size_t threads = 0);

/// Whether that is less than `seconds` on the two cores of the reference machine.
bool are_expected_within(double seconds, const Cost& cost);

/// The operations that one core of the reference machine does in a second, in dense matrices of this size.
double reference_pace(std::size_t matrix, bool complex);

}  // namespace jointid::ident
