#pragma once

#include <ostream>

#include "cli/loading_curve/loading_curve_arguments.hpp"
#include "cli/options/chosen_command.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

/// Declares `loading-curve`; choosing it stores it.
void add_loading_curve(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const LoadingCurveArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
