#pragma once

#include <ostream>

#include "cli/options/exit_code.hpp"
#include "cli/options/target.hpp"
#include "laws/scene/law_scene.hpp"

namespace jointid::cli {

/// Where the results of a scene of friction laws go.
struct LawTargets {
  Target json, csv;
  Target report{};  ///< HTML
};

/// Identifies the laws of a scene: `jointid solve`. The report goes to `out`. Bad input throws InputError, an end that was asked
/// for Interrupted.
ExitCode solve_laws(const laws::LawScene& scene, const LawTargets& targets, std::size_t threads, std::ostream& out);

}  // namespace jointid::cli
