#pragma once

#include <filesystem>
#include <ostream>
#include <vector>

#include "cli/options/chosen_command.hpp"
#include "cli/options/law_scene_run.hpp"
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
  LawSceneRun<PlanArguments> run_laws = nullptr;
};

/// Declares `plan` of FRFs; choosing it stores it. The arguments, for what scenes of friction laws need.
PlanArguments& add_linear_plan(CLI::App& app, Chosen& chosen);

/// Whether jointid-all is there and only it can: for scenes of friction laws.
bool is_elsewhere(const PlanArguments& arguments);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const PlanArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
