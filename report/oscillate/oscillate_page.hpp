#pragma once

#include <string>

#include "tasks/oscillate/oscillate_result.hpp"

namespace jointid::report {

/// The page of `jointid oscillate`: phase plots, Poincaré section, proper orthogonal modes, bifurcation diagram, reduced models.
std::string oscillate_report(const tasks::OscillateResult& run);

}  // namespace jointid::report
