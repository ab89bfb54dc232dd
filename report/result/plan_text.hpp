#pragma once

#include <optional>
#include <string>

#include "ident/plan/plan.hpp"
#include "tasks/bound_report.hpp"

namespace jointid::report {

/// What a plan will read, compute and leave out, for reading.
std::string plan_text(const ident::Plan& plan);

/// The same as JSON, with the predicted bounds where they were asked for.
std::string plan_json(const ident::Plan& plan, const std::optional<tasks::BoundReport>& bound = std::nullopt);

}  // namespace jointid::report
