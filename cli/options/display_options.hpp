#pragma once

#include <string>

#include "report/text/display.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

/// --units of text, CSV and page; JSON stays SI.
void add_units(CLI::App* command, std::string& units);

/// --quantity of plotted FRFs; `measured`: what "measured" means, e.g. "as the assembly's file".
void add_quantity(CLI::App* command, std::string& quantity, const std::string& measured);

/// Of the two options; "measured" is a receptance here. Throws InputError (usage) for other words than those of the options.
report::Display display_of(const std::string& units, const std::string& quantity = "receptance");

/// Throws InputError (usage) where --units is not its default for a scene of friction laws, whose results are SI.
void refuse_units(const std::string& units);

}  // namespace jointid::cli
