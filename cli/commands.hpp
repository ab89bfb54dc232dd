#pragma once

#include "cli/options/chosen_command.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

/// Declares all commands in the order of the help; the one that the command line names is stored.
void add_commands(CLI::App& app, Chosen& chosen);

}  // namespace jointid::cli
