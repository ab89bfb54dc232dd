#include "oscillation/delay/correlation.hpp"

#include <algorithm>
#include <cmath>

#include "base/statistics.hpp"
#include "oscillation/delay/checked_series.hpp"

namespace jointid::oscillation {
namespace {

double pairs_apart(std::size_t n, std::size_t theiler) {
  if (n <= theiler + 1) return 0.0;
  const double m = static_cast<double>(n - theiler - 1);
  return m * (m + 1.0) / 2.0;
}

}  // namespace

std::vector<double> correlation_sum(const RowMatrixXd& points, std::size_t theiler, std::span<const double> radii) {
  if (!std::ranges::is_sorted(radii)) wrong_option("radii", "do not ascend");
  const auto n = static_cast<std::size_t>(points.rows());
  const double pairs = pairs_apart(n, theiler);
  if (pairs == 0.0) wrong_option("theiler", "leaves no pair of " + std::to_string(n) + " points");
  std::vector<double> count(radii.size(), 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + theiler + 1; j < n; ++j) {
      const double distance = (points.row(at(i)) - points.row(at(j))).norm();
      const auto first = std::ranges::lower_bound(radii, distance);
      if (first != radii.end()) count[static_cast<std::size_t>(first - radii.begin())] += 1.0;
    }
  }
  double below = 0.0;
  for (double& c : count) c = (below += c) / pairs;
  return count;
}

CorrelationDimension correlation_dimension(std::span<const double> x, const Embedding& embedding, std::size_t theiler,
                                           std::size_t radii) {
  if (radii < 9) wrong_option("radii", "are fewer than 9");
  const RowMatrixXd points = delay_points(x, embedding);
  const double extent = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
  CorrelationDimension out;
  for (std::size_t k = 0; k < radii; ++k) {
    out.radius.push_back(extent * std::pow(500.0, static_cast<double>(k) / static_cast<double>(radii - 1)) / 1000.0);
  }
  out.sum = correlation_sum(points, theiler, out.radius);
  const double pairs = pairs_apart(static_cast<std::size_t>(points.rows()), theiler);
  std::vector<double> log_radius, log_sum;
  for (std::size_t k = 0; k < radii; ++k) {
    log_radius.push_back(std::log(out.radius[k]));
    log_sum.push_back(out.sum[k] * pairs < 50.0 ? nan : std::log(out.sum[k]));
  }
  if (extent > 0.0) out.dimension = find_plateau(log_radius, log_sum, {radii / 4 + 1 < 6 ? 6 : radii / 4 + 1, 1.0, 0.1});
  return out;
}

}  // namespace jointid::oscillation
