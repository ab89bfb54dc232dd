#pragma once

#include <string>

#include "tasks/loading_curve/loading_curve_result.hpp"

namespace jointid::report {

/// The page of fitted loading curves.
std::string loading_curve_page(const tasks::LoadingCurveResult& result);

}  // namespace jointid::report
