#pragma once

#include <exception>
#include <string>

#include "cli/options/exit_code.hpp"

namespace jointid::cli {

/// What an exception means to the one who ran the command.
struct Failure {
  ExitCode code = ExitCode::bug;
  std::string line;  ///< one line, without "jointid: error:"
};

Failure explain(const std::exception_ptr& exception);

/// "jointid: error: LINE" on stderr.
void print_error(const std::string& line);

/// "jointid: warning: LINE" on stderr, for results that are written and usable.
void print_warning(const std::string& line);

}  // namespace jointid::cli
