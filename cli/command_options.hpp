#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cli/arguments.hpp"

namespace jointid::cli {

/// Declares a command whose options fill a T; choosing the command stores that T.
template <class T>
std::pair<CLI::App*, T*> add_command(CLI::App& parent, std::optional<Arguments>& chosen, const char* name, const char* what) {
  auto arguments = std::make_shared<T>();
  CLI::App* command = parent.add_subcommand(name, what);
  command->callback([arguments, &chosen] { chosen = *arguments; });
  return {command, arguments.get()};
}

/// --json and --csv, where the result goes: `what` as JSON, `csv` as CSV.
template <class T>
void add_outputs(CLI::App* command, T& arguments, const std::string& what, const std::string& csv) {
  command->add_option("--json", arguments.json, "Write " + what + " as JSON to a file, or - for stdout");
  command->add_option("--csv", arguments.csv, "Write " + csv + " as CSV to a file, or - for stdout");
}

/// The same and --report, a page with `page`.
template <class T>
void add_outputs(CLI::App* command, T& arguments, const std::string& what, const std::string& csv, const std::string& page) {
  add_outputs(command, arguments, what, csv);
  command->add_option("--report", arguments.report, "Write one HTML page with " + page + " to a file, or - for stdout");
}

}  // namespace jointid::cli
