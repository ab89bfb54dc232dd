#pragma once

#include <algorithm>
#include <utility>

namespace jointid {

/// Where `of` is least between `low` and `high`, by golden sections until these are `width` apart: one value of `of` a step. `of` has one
/// minimum there; where it has more, one of them is found. The ends themselves are not tried.
template <class Of>
double least_between(const Of& of, double low, double high, double width) {
  constexpr double golden = 0.6180339887498949;
  double left = high - golden * (high - low), right = low + golden * (high - low);
  double at_left = of(left), at_right = of(right);
  while (high - low > width) {
    if (at_left < at_right) {
      high = std::exchange(right, left);
      left = high - golden * (high - low);
      at_right = std::exchange(at_left, of(left));
    } else {
      low = std::exchange(left, right);
      right = low + golden * (high - low);
      at_left = std::exchange(at_right, of(right));
    }
  }
  return 0.5 * (low + high);
}

/// The same for an `of` of several minima: first the least of `steps` + 1 evenly spaced values, then between its two neighbours.
template <class Of>
double least_over(const Of& of, double low, double high, int steps, double width) {
  const double step = (high - low) / steps;
  int best = 0;
  double at_best = of(low);
  for (int k = 1; k <= steps; ++k) {
    const double value = of(low + step * k);
    if (value < at_best) best = k, at_best = value;
  }
  return least_between(of, low + step * std::max(best - 1, 0), low + step * std::min(best + 1, steps), width);
}

}  // namespace jointid
