#include "response/identify/some_lines.hpp"

#include <algorithm>
#include <set>

namespace jointid::response {

std::vector<MeasuredState> some_lines(const std::vector<MeasuredState>& states, std::size_t count, double share) {
  std::set<double> all;
  for (const MeasuredState& state : states) all.insert(state.omega);
  if (all.size() < 2 * count) return {};
  const std::vector<double> lines(all.begin(), all.end());
  std::set<double> chosen;
  for (std::size_t stretch = 0; stretch < count; ++stretch) {
    const double place = (static_cast<double>(stretch) + share) * static_cast<double>(lines.size()) / static_cast<double>(count);
    chosen.insert(lines[std::min(lines.size() - 1, static_cast<std::size_t>(place))]);
  }
  std::vector<MeasuredState> some;
  std::ranges::copy_if(states, std::back_inserter(some),
                       [&](const MeasuredState& state) { return chosen.contains(state.omega); });
  return some;
}

}  // namespace jointid::response
