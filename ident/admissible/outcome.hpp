#pragma once

#include "ident/admissible/admissible_fit.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// What a fit says, its costs divided by `unit` squared so that they are χ².
Admissibility outcome_of(const AdmissibleSet& set, const AdmissibleFit& fit, double unit);

/// Says of the unknowns which constraint holds them, and cuts their intervals at their bounds.
void tell_outcome(const Plan& plan, Solution& out);

}  // namespace jointid::ident
