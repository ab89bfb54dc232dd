#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "cli/options/chosen_command.hpp"
#include "cli/options/target.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct StabilityArguments {
  std::vector<std::string> sweeps;  ///< by name; empty: all
  std::size_t scenes = 200;         ///< drawn at random
  std::uint64_t seed = 1;
  Target json, csv, report;
};

/// Declares `stability`; choosing it stores it.
void add_stability(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const StabilityArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
