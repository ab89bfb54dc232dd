#pragma once

#include <string>

#include "report/loading_curve/loading_curve_report.hpp"

namespace jointid::cli {

using jointid::report::energy_error;
using jointid::report::equivalents;
using jointid::report::LoadingCurveReport;

std::string loading_curve_text(const LoadingCurveReport& report);
std::string loading_curve_json(const LoadingCurveReport& report);
std::string loading_curve_csv(const LoadingCurveReport& report);

}  // namespace jointid::cli
