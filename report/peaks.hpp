#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace jointid::report {

/// A local maximum of a curve.
struct Peak {
  std::size_t point = 0;
  double x = 0.0, height = 0.0;
};

/// Local maxima of positive ordinates that rise by `prominence_db` or more above the lowest point on the way to a higher one on either
/// side, in the order of x; where there are more than `most`, the highest. NaN and zeros are no points.
std::vector<Peak> find_peaks(std::span<const double> x, std::span<const double> y, double prominence_db = 6.0, std::size_t most = 40);

}  // namespace jointid::report
