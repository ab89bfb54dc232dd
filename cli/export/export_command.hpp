#pragma once

#include <filesystem>
#include <ostream>
#include <string>

#include "cli/options/chosen_command.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct ExportArguments {
  std::filesystem::path from, out;  ///< a scene or a result; empty out: the name of it, here
  std::string to, as = "auto", units = "SI";
  std::size_t band = 0, first_id = 900001, threads = 0;
};

/// Declares `export`; choosing it stores it.
void add_export(CLI::App& app, Chosen& chosen);

/// Names of the files go to `out`. Bad input throws InputError.
ExitCode execute(const ExportArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
