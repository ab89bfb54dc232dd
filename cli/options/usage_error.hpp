#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace jointid::cli {

/// What is wrong with a command line, in one line that leads to the help: the word, the nearest valid one, the command.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace jointid::cli
