#pragma once

#include <filesystem>
#include <ostream>
#include <vector>

#include "cli/options/chosen_command.hpp"
#include "cli/options/target.hpp"
#include "frf/set/dof.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct PlanArguments {
  std::filesystem::path scene;
  bool bound = false;                ///< predict standard errors
  std::vector<frf::Dof> candidates;  ///< coordinates that are not there yet; only with `bound`
  Target json;
};

/// Declares `plan`; choosing it stores it.
void add_plan(CLI::App& app, Chosen& chosen);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const PlanArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
