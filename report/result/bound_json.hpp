#pragma once

#include <nlohmann/json_fwd.hpp>

#include "tasks/bound_report.hpp"

namespace jointid::report {

/// {"variances", "unknowns", "weakest", "without_coordinate", "without_lines", "with_more"}; null for what is infinite.
nlohmann::ordered_json bound_json(const tasks::BoundReport& report);

}  // namespace jointid::report
