#pragma once

#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// Seconds that the iterations of a plan and their intervals should take on this machine: its counted flops over what this machine does
/// in a tenth of a second of Cholesky factors of the same size, and bookkeeping, on so many threads (0: all cores). 0 where nothing
/// iterates. Good to a factor of four (docs/cost.md); reading, linear starts and a bootstrap are not in it.
double expected_seconds(const Cost& cost, std::size_t threads = 0);

/// Whether that is less than `seconds` on all cores; measured only where a slow machine's core alone would take longer.
bool are_expected_within(double seconds, const Cost& cost);

}  // namespace jointid::ident
