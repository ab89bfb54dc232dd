#pragma once

#include <string>

#include "report/oscillate/oscillate_run.hpp"

namespace jointid::report {

/// The page of `jointid oscillate`: phase plots, Poincaré section, proper orthogonal modes, bifurcation diagram, reduced models.
std::string oscillate_report(const OscillateRun& run);

}  // namespace jointid::report
