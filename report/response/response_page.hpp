#pragma once

#include <string>

#include "tasks/response/response_result.hpp"

namespace jointid::report {

/// The page of `jointid response`: FRFs of all levels, harmonics, peaks over level, loops, curves, equivalent joints, transients.
std::string response_report(const tasks::ResponseScene& scene, const tasks::ResponseResult& run);

}  // namespace jointid::report
