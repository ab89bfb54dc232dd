#pragma once

#include <string>

#include "cli/problem/reproduction_text.hpp"

namespace jointid::cli {

/// The page of a table of the thesis beside ours.
std::string reproduction_report(const ReproductionReport& report);

}  // namespace jointid::cli
