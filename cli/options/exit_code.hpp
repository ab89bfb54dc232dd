#pragma once

namespace jointid::cli {

/// What the command tells the shell.
enum class ExitCode : int {
  done = 0,
  usage = 2,       ///< wrong use or a wrong scene
  data = 3,        ///< unreadable, unwritable or inconsistent data, or not enough memory for them
  unusable = 4,    ///< the numbers are not usable; results are written and marked
  bug = 70,        ///< an exception that should not exist
  interrupted = 130
};

}  // namespace jointid::cli
