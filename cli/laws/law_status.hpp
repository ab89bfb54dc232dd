#pragma once

#include "cli/options/exit_code.hpp"
#include "laws/scene/law_scene.hpp"
#include "laws/task/identify_laws.hpp"

namespace jointid::cli {

/// Says on stderr why a result of the scene is doubtful or unusable, if it is.
ExitCode tell_status(const laws::LawScene& scene, laws::LawStatus status, const std::string& message);

}  // namespace jointid::cli
