#pragma once

#include <optional>
#include <ranges>

namespace jointid::gui {

/// The nearest of `things`, by the distance that is given for each; empty where none is nearer than `reach`.
template <std::ranges::range Things, class Distance>
std::optional<std::ranges::range_value_t<Things>> nearest(const Things& things, double reach, const Distance& distance) {
  std::optional<std::ranges::range_value_t<Things>> found;
  for (const auto& each : things) {
    const double away = distance(each);
    if (away >= reach) continue;
    reach = away;
    found = each;
  }
  return found;
}

}  // namespace jointid::gui
