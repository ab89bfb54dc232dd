#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ident/result/solution.hpp"

namespace jointid::report {

/// [{"worst": {"unknowns", "factors", "deviation"}, "best": … or null, "correlation"}]
nlohmann::ordered_json weakest_json(const std::vector<ident::WeakCombination>& weakest);

/// {"intervals", "largest_relative_error", "joint": {"effect", "deformation"}, "weakest", "findings": [{"kind", "text"}]}, or
/// null for methods that know nothing of it.
nlohmann::ordered_json identifiability_json(const ident::Solution& solution);

}  // namespace jointid::report
