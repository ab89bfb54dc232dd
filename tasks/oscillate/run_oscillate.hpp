#pragma once

#include <functional>

#include "ident/result/control.hpp"
#include "tasks/oscillate/oscillate_result.hpp"

namespace jointid::tasks {

/// Integrates the motion of a scene exactly and finds what else it asks for, in its order: modes, orbit, exponents, sweep,
/// reduced models. Of `control`, `threads` are those of the sweep (the results do not depend on it), `progress` is told per cent
/// of 100, or of a stage that has none a total of 0, and `interrupted` is asked all along. `so_far` gets the result after each
/// part, and within the sweep after each point. A motion, orbit or model that does not end well is told in the result
/// (failure_of()). Throws InputError (data), and Interrupted.
OscillateResult run_oscillate(const OscillateScene& scene, const ident::Control& control = {},
                              const std::function<void(const OscillateResult&)>& so_far = {});

}  // namespace jointid::tasks
