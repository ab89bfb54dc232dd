#include "response/identify/harmonics_to_add.hpp"

#include <algorithm>

namespace jointid::response {

HarmonicsToAdd::HarmonicsToAdd(const Receptance& structure, const std::vector<MeasuredState>& states, int largest)
    : structure_(structure), states_(states), most_(largest) {
  for (const MeasuredState& state : states) {
    for (const auto* numbers : {&state.harmonics, &state.force.harmonics}) {
      first_ = std::max(first_, numbers->back());
      odd_ = odd_ && std::ranges::all_of(*numbers, [](int n) { return n % 2 == 1; });
    }
  }
}

std::vector<int> HarmonicsToAdd::to(int largest) const {
  return odd_ ? Harmonics::odd(largest).numbers() : Harmonics::all(largest).numbers();
}

int HarmonicsToAdd::after(int largest) const {
  const int next = largest + (odd_ && largest % 2 == 0 ? 1 : 2);
  if (next > most_) return 0;
  for (int n = next; n > largest; n -= odd_ ? 2 : 1) {
    if (std::ranges::any_of(states_, [&](const MeasuredState& state) { return structure_.covers(n * state.omega); })) return next;
  }
  return 0;
}

}  // namespace jointid::response
