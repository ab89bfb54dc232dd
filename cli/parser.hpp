#pragma once

#include <string>
#include <variant>

#include "cli/options/chosen_command.hpp"
#include "cli/options/exit_code.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

/// What to print instead of doing anything: help, version or what is wrong with the command line.
struct Notice {
  ExitCode code = ExitCode::done;
  std::string text;         ///< for stdout when the code is `done`, else one line for stderr
  bool is_version = false;  ///< the same in every program
};

/// Reads the command line of a program whose commands add_commands() declares in the order of the help.
std::variant<ChosenCommand, Notice> parse(int argc, const char* const* argv, void (*add_commands)(CLI::App& app, Chosen& chosen));

}  // namespace jointid::cli
