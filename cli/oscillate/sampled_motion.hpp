#pragma once

#include <functional>

#include "cli/oscillate/oscillate_run.hpp"

namespace jointid::cli {

/// Integrates the scene's motion; `share` is told what part of the time is done. Throws Interrupted.
SampledMotion sampled_motion(const OscillateScene& scene, const oscillation::ContactSystem& system,
                             const std::function<void(double)>& share);

}  // namespace jointid::cli
