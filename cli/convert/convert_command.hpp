#pragma once

#include <filesystem>
#include <ostream>
#include <vector>

#include "cli/options/chosen_command.hpp"
#include "frf/set/frf_source.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct ConvertArguments {
  std::vector<std::filesystem::path> in;
  std::filesystem::path out;
  frf::OpenOptions open;
};

/// Declares `convert`; choosing it stores it.
void add_convert(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const ConvertArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
