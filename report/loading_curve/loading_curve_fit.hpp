#pragma once

#include <functional>
#include <string>

#include "report/loading_curve/loading_curve_report.hpp"
#include "report/loading_curve/loading_curve_task.hpp"

namespace jointid::report {

/// How fitting is watched and stopped; each may be empty.
struct FittingWatch {
  std::function<bool()> interrupted{};
  std::function<void(const std::string& stage)> progress{};
  std::function<void(const LoadingCurveReport&)> so_far{};  ///< after every law
};

/// Reads the curves and fits every law, best by AIC first; of records with several loops each law to all loops together and then
/// to each alone. Throws InputError (data, or usage for a task that the data contradict), and Interrupted.
LoadingCurveReport fit_loading_curves(const LoadingCurveTask& task, const FittingWatch& watch);

}  // namespace jointid::report
