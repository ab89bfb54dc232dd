#pragma once

#include <ostream>

#include "cli/options/chosen_command.hpp"
#include "cli/oscillate/oscillate_arguments.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

/// Declares `oscillate`; choosing it stores it.
void add_oscillate(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const OscillateArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
