#pragma once

#include <filesystem>
#include <ostream>

#include "cli/options/chosen_command.hpp"
#include "cli/options/target.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct EquivalentArguments {
  std::filesystem::path scene;
  Target json, csv;
  Target report{};  ///< HTML
  std::string units = "SI";  ///< of text, CSV and page: SI or mm
};

/// Declares `equivalent`; choosing it stores it.
void add_equivalent(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const EquivalentArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
