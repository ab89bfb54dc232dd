#pragma once

#include <ostream>

#include "cli/options/exit_code.hpp"
#include "cli/options/target.hpp"
#include "laws/scene/law_scene.hpp"
#include "laws/task/identify_laws.hpp"

namespace jointid::cli {

/// Where the results of a scene of friction laws go.
struct LawTargets {
  Target json, csv;
  Target report{};  ///< HTML
};

/// Says on stderr why a result of the scene is doubtful or unusable, if it is.
ExitCode tell_status(const laws::LawScene& scene, laws::LawStatus status, const std::string& message);

/// Identifies the laws of a scene: `jointid solve`. The report goes to `out`. Bad input throws InputError, an end that was asked
/// for Interrupted.
ExitCode solve_laws(const laws::LawScene& scene, const LawTargets& targets, std::size_t threads, std::ostream& out);

}  // namespace jointid::cli
