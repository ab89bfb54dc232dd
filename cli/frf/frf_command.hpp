#pragma once

#include <ostream>

#include "cli/frf/frf_arguments.hpp"
#include "cli/options/chosen_command.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

/// Declares `frf`; choosing it stores it.
void add_frf(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const FrfArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
