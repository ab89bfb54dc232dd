#pragma once

#include <ostream>

#include "cli/modalfit/modalfit_arguments.hpp"
#include "cli/options/chosen_command.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

/// Declares `modalfit`; choosing it stores it.
void add_modalfit(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const ModalfitArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
