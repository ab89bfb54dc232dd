#pragma once

#include <filesystem>
#include <ostream>
#include <string>

#include "cli/options/chosen_command.hpp"
#include "cli/options/target.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct RerunArguments {
  std::filesystem::path result, folder;
  Target json;
};

/// Declares `rerun`; choosing it stores it.
void add_rerun(CLI::App& app, Chosen& chosen);

/// Repeats the run that made a JSON result, and tells whether inputs and answers are the same: done if they are, `unusable` if answers
/// differ. Bad input throws InputError.
ExitCode execute(const RerunArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
