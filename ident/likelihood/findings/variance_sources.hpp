#pragma once

#include "ident/plan/plan.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// Where a plan takes the variances of its FRFs from, one entry per file; empty for methods that use none. Notes come after the
/// FRFs have been read.
std::vector<VarianceSource> variance_sources(const Plan& plan);

}  // namespace jointid::ident
