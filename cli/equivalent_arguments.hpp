#pragma once

#include <optional>

#include "cli/arguments.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

/// Declares the command `equivalent`; choosing it stores its arguments.
void add_equivalent(CLI::App& app, std::optional<Arguments>& chosen);

}  // namespace jointid::cli
