#pragma once

#include <cstddef>
#include <filesystem>
#include <ostream>

#include "cli/options/chosen_command.hpp"
#include "cli/options/target.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct DecoupleArguments {
  std::filesystem::path scene, out;  ///< out: empty for the scene's name with .decoupled.h5 in the current folder
  std::size_t threads = 0;           ///< 0: all cores
  Target json, csv;
};

/// Declares `decouple`; choosing it stores it.
void add_decouple(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const DecoupleArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
