#pragma once

#include <any>
#include <functional>
#include <optional>
#include <ostream>

#include "cli/options/exit_code.hpp"

namespace jointid::cli {

/// The command that a command line names.
struct ChosenCommand {
  std::any arguments;                              ///< of the command's own type, e.g. SolveArguments
  std::function<ExitCode(std::ostream&)> execute;  ///< the report goes to the stream; bad input throws InputError
  std::function<bool()> is_elsewhere = {};         ///< whether jointid-all is there and only it can; none: this program can
  bool is_shared = false;                          ///< its work, by the processes that mpirun started
};

/// Nothing until the command line is read.
using Chosen = std::optional<ChosenCommand>;

}  // namespace jointid::cli
