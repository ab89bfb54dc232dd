#pragma once

#include <filesystem>
#include <ostream>

#include "cli/options/chosen_command.hpp"
#include "cli/options/target.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct CheckArguments {
  std::filesystem::path scene;
  Target json;
};

/// Declares `check`; choosing it stores it.
void add_check(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const CheckArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
