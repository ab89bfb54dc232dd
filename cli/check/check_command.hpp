#pragma once

#include <filesystem>
#include <ostream>

#include "cli/options/chosen_command.hpp"
#include "cli/options/law_scene_run.hpp"
#include "cli/options/target.hpp"
#include "ident/result/suspect.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct CheckArguments {
  std::filesystem::path scene;
  Target json;
  LawSceneRun<CheckArguments> run_laws = nullptr;
};

/// Declares `check` of matrices; choosing it stores it. The arguments, for what scenes of a joint at every line need.
CheckArguments& add_linear_check(CLI::App& app, Chosen& chosen);

/// Whether jointid-all is there and only it can: for scenes of a joint at every line.
bool is_elsewhere(const CheckArguments& arguments);

/// Writes what was found where the arguments ask for it.
void write_check(const CheckArguments& arguments, const ident::CheckResult& result, std::ostream& out);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const CheckArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
