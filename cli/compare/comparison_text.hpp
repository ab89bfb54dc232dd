#pragma once

#include <string>

#include "study/comparison.hpp"

namespace jointid::cli {

/// A comparison and what it took.
struct ComparisonReport {
  std::string title;  ///< of the scene
  std::size_t trials = 0;
  std::uint64_t seed = 0;
  study::Comparison comparison;
};

/// Per matrix the table of the thesis (rows weighting, columns Δ, cells RJCF and ARVF) when there are several Δ, and one row per
/// combination; then time and memory, and what was left out.
std::string comparison_text(const ComparisonReport& report);

/// One object per combination; keys stay.
std::string comparison_json(const ComparisonReport& report);

/// One line per combination and matrix.
std::string comparison_csv(const ComparisonReport& report);

}  // namespace jointid::cli
