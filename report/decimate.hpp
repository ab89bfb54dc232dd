#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace jointid::report {

/// Which of the points of some curves over one axis to draw so that at most about `most` are left and no peak is lost: the
/// axis is cut into equal numbers of points, of each piece the first, the last, and the least and greatest of every curve
/// stay. Ascending; all points when there are no more than `most`. NaN is never least or greatest. Curves: equally long.
std::vector<std::size_t> keep_peaks(std::span<const std::vector<double>> curves, std::size_t most);

/// The values at `indices`.
std::vector<double> picked(const std::vector<double>& values, std::span<const std::size_t> indices);

}  // namespace jointid::report
