#pragma once

#include <string>

#include "tasks/compare/compare_ways.hpp"

namespace jointid::report {

/// Per matrix the table of the thesis (rows weighting, columns Δ, cells RJCF and ARVF) when there are several Δ, and one row per
/// combination; then time and memory, and what was left out.
std::string comparison_text(const tasks::ComparisonResult& result);

/// One object per combination; keys stay.
std::string comparison_json(const tasks::ComparisonResult& result);

/// One line per combination and matrix.
std::string comparison_csv(const tasks::ComparisonResult& result);

}  // namespace jointid::report
