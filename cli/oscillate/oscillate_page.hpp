#pragma once

#include <string>

#include "cli/oscillate/oscillate_run.hpp"

namespace jointid::cli {

/// The page of `jointid oscillate`: phase plots, Poincaré section, proper orthogonal modes, bifurcation diagram, reduced models.
std::string oscillate_report(const OscillateRun& run);

}  // namespace jointid::cli
