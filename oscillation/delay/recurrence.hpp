#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/eigen.hpp"

namespace jointid::oscillation {

/// A stretch of a record that nearly closes: a start for Newton's search of a periodic orbit, stable or not (Auerbach et al.
/// 1987).
struct Recurrence {
  std::size_t start = 0, period = 0;  ///< samples
  double distance = 0.0;              ///< ‖y_{start+period} − y_start‖
};

/// Half the mean distance of consecutive points, the default ball.
double half_mean_step(const RowMatrixXd& points);

/// For every i the smallest k > i with ‖y_k − y_i‖ < radius after the orbit has left the ball (otherwise k = i + 1; not in the
/// thesis, 3.5.4). Points that do not return are left out.
std::vector<Recurrence> recurrences(const RowMatrixXd& points, double radius);

/// Of recurrences whose periods lie within `width` samples of each other the one that closes best, for every such group, the most
/// frequent first.
struct RecurrentPeriod {
  Recurrence best;
  std::size_t count = 0;
};
std::vector<RecurrentPeriod> recurrent_periods(const std::vector<Recurrence>& found, std::size_t width);

}  // namespace jointid::oscillation
