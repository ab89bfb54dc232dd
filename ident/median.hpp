#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace jointid::ident {

/// The upper of the two middle ones of an even number; NaN of none.
inline double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace jointid::ident
