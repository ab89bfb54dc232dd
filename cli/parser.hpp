#pragma once

#include <string>
#include <variant>

#include "cli/options/chosen_command.hpp"
#include "cli/options/exit_code.hpp"

namespace jointid::cli {

/// What to print instead of doing anything: help, version or what is wrong with the command line.
struct Notice {
  ExitCode code = ExitCode::done;
  std::string text;  ///< for stdout when the code is `done`, else one line for stderr
};

/// Reads the command line.
std::variant<ChosenCommand, Notice> parse(int argc, const char* const* argv);

}  // namespace jointid::cli
