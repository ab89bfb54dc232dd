#pragma once

#include <string>

#include "cli/loading_curve/loading_curve_report.hpp"
#include "report/loading_curve/loading_curve_report.hpp"

namespace jointid::cli {

/// The page of fitted loading curves.
std::string loading_curve_report(const report::LoadingCurveReport& report);

}  // namespace jointid::cli
