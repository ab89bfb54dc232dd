#pragma once

#include "cli/parser.hpp"

namespace jointid::cli {

/// How a program reads its command line.
using Parse = std::variant<ChosenCommand, Notice> (*)(int argc, const char* const* argv);

/// Of `jointid`: the commands that lead from FRFs to a joint. What it cannot do, it leaves to jointid-all where that is there.
std::variant<ChosenCommand, Notice> parse_first(int argc, const char* const* argv);

/// Of `jointid-all`: all commands.
std::variant<ChosenCommand, Notice> parse_all(int argc, const char* const* argv);

}  // namespace jointid::cli
