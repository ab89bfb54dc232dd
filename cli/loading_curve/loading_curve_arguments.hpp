#pragma once

#include <optional>
#include <string>

#include "tasks/loading_curve/loading_curve_task.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct LoadingCurveArguments : tasks::LoadingCurveTask {
  std::optional<std::string> json, csv, report;
};

/// Declares the options of `jointid loading-curve` on its command.
void declare(CLI::App& command, LoadingCurveArguments& arguments);

/// Throws InputError (usage) for a command line that cannot be carried out, as far as it can be seen without the data.
void check(const LoadingCurveArguments& arguments);

}  // namespace jointid::cli
