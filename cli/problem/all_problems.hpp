#pragma once

#include "cli/options/chosen_command.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

/// Declares `problem` with all built-in problems; choosing one of its commands stores it.
void add_problem(CLI::App& app, Chosen& chosen);

}  // namespace jointid::cli
