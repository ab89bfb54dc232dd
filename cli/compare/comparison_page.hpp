#pragma once

#include <string>

#include "cli/compare/comparison_text.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::cli {

/// The page of a comparison on a scene.
std::string comparison_report(const ComparisonReport& report, const ident::Scene& scene);

}  // namespace jointid::cli
