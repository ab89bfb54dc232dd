#pragma once

#include <optional>

#include "cli/arguments.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

/// Declares the command `couple`; choosing it stores its arguments.
void add_couple(CLI::App& app, std::optional<Arguments>& chosen);

}  // namespace jointid::cli
