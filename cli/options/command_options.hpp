#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <ostream>
#include <string>
#include <utility>

#include "cli/options/chosen_command.hpp"
#include "cli/options/output.hpp"
#include "cli/options/whole_number.hpp"

namespace jointid::cli {

/// Declares a command whose options fill a T; choosing the command stores that T, what executes it and, where there are such,
/// T::is_shared and the function is_elsewhere() of it.
template <class T>
std::pair<CLI::App*, T*> add_command(CLI::App& parent, Chosen& chosen, const char* name, const char* what) {
  auto arguments = std::make_shared<T>();
  CLI::App* command = parent.add_subcommand(name, what);
  command->callback([arguments, &chosen] {
    chosen = ChosenCommand{*arguments, [arguments](std::ostream& out) { return execute(*arguments, out); }};
    if constexpr (requires { T::is_shared; }) chosen->is_shared = T::is_shared;
    if constexpr (requires { is_elsewhere(*arguments); }) chosen->is_elsewhere = [arguments] { return is_elsewhere(*arguments); };
  });
  return {command, arguments.get()};
}

/// --force, also called --overwrite where a command means another force.
inline void add_force(CLI::App* command) {
  const bool taken = command->get_option_no_throw("--force") != nullptr;
  command->add_flag_callback(taken ? "--overwrite" : "--force,--overwrite", allow_overwriting, "Replace files that jointid did not write");
}

/// --json and --csv, where the result goes: `what` as JSON, `csv` as CSV.
template <class T>
void add_outputs(CLI::App* command, T& arguments, const std::string& what, const std::string& csv) {
  command->add_option("--json", arguments.json, "Write " + what + " as JSON to a file, or - for stdout");
  command->add_option("--csv", arguments.csv, "Write " + csv + " as CSV to a file, or - for stdout");
  add_force(command);
}

/// The same and --report, a page with `page`.
template <class T>
void add_outputs(CLI::App* command, T& arguments, const std::string& what, const std::string& csv, const std::string& page) {
  add_outputs(command, arguments, what, csv);
  command->add_option("--report", arguments.report, "Write one page with " + page + " to a file .html or .pdf, or - for stdout (HTML)");
}

/// --trials, --seed and --threads of commands that draw noise.
template <class T>
void add_trial_options(CLI::App* command, T& arguments) {
  add_whole_number(command, "--trials", arguments.trials, "How often", counts_of_trials());
  add_whole_number(command, "--seed", arguments.seed, "Of the noise", {});
  add_whole_number(command, "--threads", arguments.threads, "0 for all cores; the results do not depend on it", counts_of_threads());
}

}  // namespace jointid::cli
