#pragma once

#include <string>
#include <vector>

#include "ident/result/solution.hpp"

namespace jointid::report {

/// Where the variances of the FRFs come from, a line for each file; of many files one for each origin. Empty for none.
std::string variances_text(const std::vector<ident::VarianceSource>& files);

}  // namespace jointid::report
