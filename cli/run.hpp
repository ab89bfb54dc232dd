#pragma once

#include "cli/commands.hpp"

namespace jointid::cli {

/// A whole program: reads the arguments, does the work, and maps every error to one line on stderr and an exit code.
int run(int argc, const char* const* argv, Parse parse);

}  // namespace jointid::cli
