#pragma once

#include <string>
#include <vector>

#include "coupling/line_coupler.hpp"

namespace jointid::coupling {

/// What the alphas of a condition (docs/formulas.md §8, 5.70) say over the lines.
struct Dependency {
  std::string condition;
  double median = 0.0, lower = 0.0, upper = 0.0;  ///< of alpha; 5 and 95 % quantiles
  bool dependent = false;
};

struct Dependencies {
  std::vector<Dependency> conditions;
  double threshold = 0.0;  ///< dependent conditions have a median below it; 0: none are
  std::string reason;      ///< one sentence

  std::vector<bool> left_out() const;
};

/// The conditions that those before them nearly imply (thesis §5.8.3, §5.9.3), from the alphas of mtc() on all lines. Alpha
/// swings over the lines (it is large at antiresonances), so that its median counts, and it is relative: coordinates that move
/// on their own have alphas of about 1, those that others hold have that of the noise. Sorted from
/// above, with 1 counting as one of them, the medians are parted at the first that is below 0.3 and at most a third of the one
/// before it; it and all below are dependent. Lines without an alpha are left out.
Dependencies find_dependencies(const std::vector<std::string>& conditions, const std::vector<LineRecord>& lines);

}  // namespace jointid::coupling
