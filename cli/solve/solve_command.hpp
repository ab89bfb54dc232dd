#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>

#include "cli/options/chosen_command.hpp"
#include "cli/options/law_scene_run.hpp"
#include "cli/options/target.hpp"
#include "cli/resume/resume_options.hpp"

namespace CLI {
class App;
}

namespace jointid::cli {

struct SolveArguments {
  static constexpr bool is_shared = true;
  std::filesystem::path scene;
  Target json, csv;
  Target report;  ///< HTML
  std::optional<std::string> plot;  ///< RESPONSE/REFERENCE of an assembly FRF
  std::string units = "SI";  ///< of text, CSV and page: SI or mm
  std::string quantity = "receptance";  ///< of plotted FRFs; "measured": that of the assembly's file
  Target by_line;  ///< the unknowns over the lines: JSON where the name ends in .json, else CSV
  Target by_iteration;  ///< the objective and the unknowns over the iterations, the same
  std::size_t threads = 0;
  ResumeOptions resume;
  LawSceneRun<SolveArguments> run_laws = nullptr;
};

/// Declares `solve` of FRFs; choosing it stores it. The arguments, for what scenes of friction laws need.
SolveArguments& add_linear_solve(CLI::App& app, Chosen& chosen);

/// Whether jointid-all is there and only it can: for scenes of friction laws.
bool is_elsewhere(const SolveArguments& arguments);

/// The report goes to `out`. Bad input throws InputError.
ExitCode execute(const SolveArguments& arguments, std::ostream& out);

}  // namespace jointid::cli
