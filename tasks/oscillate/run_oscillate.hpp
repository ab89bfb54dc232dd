#pragma once

#include <functional>

#include "ident/result/control.hpp"
#include "tasks/oscillate/oscillate_result.hpp"

namespace jointid::tasks {

/// Integrates the motion of a scene exactly and computes its other results in this order: modes, orbit, exponents, sweep, reduced
/// models. `control.threads` are those of the sweep (the results do not depend on it). `progress` gets per cent of 100; a stage
/// without a total has 0. `interrupted` is called throughout. `so_far` gets the result after each part, and within the sweep
/// after each point. Failures of a motion, orbit or model are in the result (failure_of()). Throws InputError (data), and
/// Interrupted.
OscillateResult run_oscillate(const OscillateScene& scene, const ident::Control& control = {},
                              const std::function<void(const OscillateResult&)>& so_far = {});

}  // namespace jointid::tasks
