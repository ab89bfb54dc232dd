#pragma once

#include <filesystem>
#include <ostream>

#include "cli/options/exit_code.hpp"
#include "cli/options/target.hpp"

namespace jointid::cli {

/// Where the results of a scene of friction laws go.
struct LawTargets {
  Target json, csv;
  Target report{};  ///< HTML
};

/// Whether the file holds a scene of friction laws. Throws InputError (usage) for a file that is not there, or no TOML.
bool holds_law_scene(const std::filesystem::path& scene);

/// Identifies the laws of a scene: `jointid solve`. The report goes to `out`. Bad input throws InputError.
ExitCode solve_laws(const std::filesystem::path& scene, const LawTargets& targets, std::ostream& out);

}  // namespace jointid::cli
