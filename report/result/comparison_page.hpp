#pragma once

#include <string>

#include "ident/scene/scene.hpp"
#include "report/result/comparison_text.hpp"

namespace jointid::report {

/// The page of a comparison on a scene.
std::string comparison_page(const tasks::ComparisonResult& result, const ident::Scene& scene);

}  // namespace jointid::report
