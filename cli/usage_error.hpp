#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace jointid::cli {

/// What is wrong with a command line, in one line that leads to the help: the word, the nearest valid one, the command.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace jointid::cli
