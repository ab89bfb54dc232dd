#pragma once

#include <string>

#include "base/status.hpp"
#include "cli/options/exit_code.hpp"

namespace jointid::cli {

/// done for a result that is usable, else unusable; says on stderr why a result of `of` (its file) is doubtful or unusable, if it is.
ExitCode tell_status(const std::string& of, Status status, const std::string& message);

}  // namespace jointid::cli
