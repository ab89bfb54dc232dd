#pragma once

#include <string>

#include "cli/stability/stability_report.hpp"

namespace jointid::cli {

/// The page of `jointid stability`: digits against what each sweep varies, time against digits, and the verdicts.
std::string stability_report(const StabilityReport& report);

}  // namespace jointid::cli
