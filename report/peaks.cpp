#include "report/peaks.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::report {
namespace {

/// The least ordinate from a peak to the next higher one by `step`, or to the end.
double valley(std::span<const double> y, const std::vector<std::size_t>& points, std::size_t peak, std::ptrdiff_t step) {
  const double height = y[points[peak]];
  double least = height;
  for (auto i = static_cast<std::ptrdiff_t>(peak) + step; i >= 0 && i < static_cast<std::ptrdiff_t>(points.size()); i += step) {
    const double at = y[points[static_cast<std::size_t>(i)]];
    if (at > height) break;
    least = std::min(least, at);
  }
  return least;
}

}  // namespace

std::vector<Peak> find_peaks(std::span<const double> x, std::span<const double> y, double prominence_db, std::size_t most) {
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (std::isfinite(y[i]) && y[i] > 0.0) points.push_back(i);
  }
  const double rise = std::pow(10.0, prominence_db / 20.0);
  std::vector<Peak> out;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double at = y[points[i]];
    if (!(at > y[points[i - 1]]) || at < y[points[i + 1]]) continue;
    const double below = std::max(valley(y, points, i, -1), valley(y, points, i, 1));
    if (at >= rise * below) out.push_back({points[i], x[points[i]], at});
  }
  if (out.size() > most) {
    std::ranges::stable_sort(out, std::ranges::greater(), &Peak::height);
    out.resize(most);
    std::ranges::sort(out, {}, &Peak::point);
  }
  return out;
}

}  // namespace jointid::report
