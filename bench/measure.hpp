#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/statistics.hpp"

namespace jointid::bench {

using median;

/// Of elements [first, last), relative to the largest of b's.
inline double largest_difference(const std::vector<double>& a, const std::vector<double>& b, std::size_t first, std::size_t last) {
  double difference = 0.0, largest = 0.0;
  for (std::size_t i = first; i < last; ++i) {
    difference = std::max(difference, std::abs(a[i] - b[i]));
    largest = std::max(largest, std::abs(b[i]));
  }
  return difference / largest;
}

/// The same of 20 unknowns in the order K, D: stiffness and damping each against their own largest element.
inline double largest_difference_of_case_a1(const std::vector<double>& a, const std::vector<double>& b) {
  return std::max(largest_difference(a, b, 0, 10), largest_difference(a, b, 10, 20));
}

}  // namespace jointid::bench
