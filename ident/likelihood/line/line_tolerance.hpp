#pragma once

#include <algorithm>
#include <vector>

namespace jointid::ident {

/// A line with χ² above this multiple of its redundancy (and of line_tolerance()) counts for less.
inline constexpr double outlying = 1.5 * 1.5;

/// How much more than expected lines may be off, from their χ² over redundancy: that of the middle one where it is outlying, else
/// 1. While most lines do not fit, that is no reason to trust a few.
inline double line_tolerance(std::vector<double> ratios) {
  if (ratios.empty()) return 1.0;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::ranges::nth_element(ratios, middle);
  return *middle > outlying ? *middle : 1.0;
}

}  // namespace jointid::ident
