#pragma once

#include <CLI/App.hpp>
#include <optional>

#include "cli/arguments.hpp"

namespace jointid::cli {

/// Declares `modalfit`; choosing it stores its arguments.
void add_modalfit(CLI::App& app, std::optional<Arguments>& chosen);

/// "400:1000" in Hz; either side may be left out. Throws InputError (usage).
std::array<double, 2> parse_range(const std::string& text);

}  // namespace jointid::cli
