#pragma once

namespace jointid::cli {

/// The whole command: reads the arguments, does the work, and maps every error to one line on stderr and an exit code.
int run(int argc, const char* const* argv);

}  // namespace jointid::cli
