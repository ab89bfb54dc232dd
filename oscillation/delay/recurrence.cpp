#include "oscillation/delay/recurrence.hpp"

#include <algorithm>

namespace jointid::oscillation {

double half_mean_step(const RowMatrixXd& points) {
  if (points.rows() < 2) return 0.0;
  const Eigen::Index steps = points.rows() - 1;
  return 0.5 * (points.bottomRows(steps) - points.topRows(steps)).rowwise().norm().mean();
}

std::vector<Recurrence> recurrences(const RowMatrixXd& points, double radius) {
  std::vector<Recurrence> found;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    bool outside = false;
    for (Eigen::Index k = i + 1; k < points.rows(); ++k) {
      const double distance = (points.row(k) - points.row(i)).norm();
      outside = outside || distance >= radius;
      if (outside && distance < radius) {
        found.push_back({static_cast<std::size_t>(i), static_cast<std::size_t>(k - i), distance});
        break;
      }
    }
  }
  return found;
}

std::vector<RecurrentPeriod> recurrent_periods(const std::vector<Recurrence>& found, std::size_t width) {
  std::vector<Recurrence> by_period = found;
  std::ranges::stable_sort(by_period, {}, &Recurrence::period);
  std::vector<RecurrentPeriod> groups;
  std::size_t last = 0;
  for (const Recurrence& each : by_period) {
    if (groups.empty() || each.period > last + width) groups.push_back({each, 0});
    last = each.period;
    groups.back().count += 1;
    if (each.distance < groups.back().best.distance) groups.back().best = each;
  }
  std::ranges::stable_sort(groups, std::greater<>(), &RecurrentPeriod::count);
  return groups;
}

}  // namespace jointid::oscillation
