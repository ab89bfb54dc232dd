#pragma once

#include <functional>
#include <string>

#include "tasks/loading_curve/loading_curve_result.hpp"
#include "tasks/loading_curve/loading_curve_task.hpp"

namespace jointid::tasks {

/// How fitting is watched and stopped; each may be empty.
struct FittingWatch {
  std::function<bool()> interrupted{};
  std::function<void(const std::string& stage)> progress{};
  std::function<void(const LoadingCurveResult&)> so_far{};  ///< after every law
};

/// Reads the curves and fits every law, best by AIC first; of records with several loops each law to all loops together and then
/// to each alone. Throws InputError (data, or usage for a task that the data contradict), and Interrupted.
LoadingCurveResult fit_loading_curves(const LoadingCurveTask& task, const FittingWatch& watch = {});

/// The same of curves in memory (friction::loading_curve(), loop_curve()), SI units: what the task says of files and columns does
/// not apply, normal loads and units are those of the curves. Throws InputError (usage) for curves that friction::validate()
/// refuses.
LoadingCurveResult fit_loading_curves(LoadingCurveData data, const LoadingCurveTask& task, const FittingWatch& watch = {});

}  // namespace jointid::tasks
