#include "tasks/joint/run_difference.hpp"

#include <algorithm>
#include <cmath>

#include "base/statistics.hpp"
#include "tasks/joint/joint_springs.hpp"

namespace jointid::tasks {

std::vector<UnknownDifference> run_differences(const std::vector<ident::Estimate>& first, const std::vector<ident::Estimate>& second) {
  std::vector<UnknownDifference> out;
  for (const ident::Estimate& one : first) {
    const auto other = std::ranges::find(second, one.name, &ident::Estimate::name);
    if (other == second.end() || other->unit != one.unit || !one.determined || !other->determined) continue;
    UnknownDifference each{.name = one.name, .unit = one.unit, .first = one.value, .second = other->value,
                           .first_half = half_width(one), .second_half = half_width(*other),
                           .difference = other->value - one.value, .half = {}, .relative = nan};
    if (each.first_half && each.second_half) each.half = std::hypot(*each.first_half, *each.second_half);
    if (std::abs(each.first) > 0.0) each.relative = each.difference / std::abs(each.first);
    out.push_back(std::move(each));
  }
  return out;
}

}  // namespace jointid::tasks
