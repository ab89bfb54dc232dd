#pragma once

#include <string>

#include "cli/loading_curve/loading_curve_report.hpp"

namespace jointid::cli::report {

/// The page of fitted loading curves.
std::string loading_curve_report(const LoadingCurveReport& report);

}  // namespace jointid::cli::report
