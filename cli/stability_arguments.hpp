#pragma once

#include "cli/arguments.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

/// Declares the options of `jointid stability` on its command.
void declare(CLI::App& command, StabilityArguments& arguments);

}  // namespace jointid::cli
