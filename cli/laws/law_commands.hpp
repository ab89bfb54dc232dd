#pragma once

#include "cli/options/chosen_command.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

/// Declares `solve` of all scenes, of FRFs and of friction laws; choosing it stores it.
void add_solve(CLI::App& app, Chosen& chosen);

/// Declares `plan` of all scenes; choosing it stores it.
void add_plan(CLI::App& app, Chosen& chosen);

/// Declares `check` of all scenes of FRFs; choosing it stores it.
void add_check(CLI::App& app, Chosen& chosen);

}  // namespace jointid::cli
