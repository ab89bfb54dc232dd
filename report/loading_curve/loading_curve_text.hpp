#pragma once

#include <string>

#include "tasks/loading_curve/loading_curve_result.hpp"

namespace jointid::report {

/// What was fitted, for people: the laws compared, parameters of the best one, equivalent stiffness and damping.
std::string loading_curve_text(const tasks::LoadingCurveResult& result);
/// The same as JSON; the keys stay. Numbers that are not there are null.
std::string loading_curve_json(const tasks::LoadingCurveResult& result);
/// One line for each parameter of each law and curve.
std::string loading_curve_csv(const tasks::LoadingCurveResult& result);

}  // namespace jointid::report
