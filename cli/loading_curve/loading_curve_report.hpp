#pragma once

#include <string>

#include "report/loading_curve/loading_curve_report.hpp"

namespace jointid::cli {

std::string loading_curve_text(const report::LoadingCurveReport& report);
std::string loading_curve_json(const report::LoadingCurveReport& report);
std::string loading_curve_csv(const report::LoadingCurveReport& report);

}  // namespace jointid::cli
