#pragma once

#include <ostream>

#include "cli/compare/compare_arguments.hpp"
#include "cli/options/chosen_command.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

/// Declares `compare`; choosing it stores it.
void add_compare(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const CompareArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
