#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>

#include "cli/options/chosen_command.hpp"
#include "cli/options/target.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct SolveArguments {
  std::filesystem::path scene;
  Target json, csv;
  Target report;  ///< HTML
  std::optional<std::string> plot;  ///< RESPONSE/REFERENCE of an assembly FRF
  std::size_t threads = 0;
};

/// Declares `solve`; choosing it stores it.
void add_solve(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const SolveArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
