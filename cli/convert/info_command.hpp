#pragma once

#include <filesystem>
#include <ostream>

#include "cli/options/chosen_command.hpp"
#include "frf/set/frf_source.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct InfoArguments {
  std::filesystem::path file;
  frf::OpenOptions open;
};

/// Declares `info`; choosing it stores it.
void add_info(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const InfoArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
