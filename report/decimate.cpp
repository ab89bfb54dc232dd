#include "report/decimate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace jointid::report {
namespace {

/// Appends the places of the least and the greatest of curve[first, last).
void add_extremes(const std::vector<double>& curve, std::size_t first, std::size_t last,
                  std::vector<std::size_t>& kept) {
  std::size_t least = last, greatest = last;
  for (std::size_t i = first; i < last; ++i) {
    if (std::isnan(curve[i])) continue;
    if (least == last || curve[i] < curve[least]) least = i;
    if (greatest == last || curve[i] > curve[greatest]) greatest = i;
  }
  if (least == last) return;
  kept.push_back(least);
  kept.push_back(greatest);
}

}  // namespace

std::vector<std::size_t> keep_peaks(std::span<const std::vector<double>> curves, std::size_t most) {
  const std::size_t points = curves.empty() ? 0 : curves.front().size();
  std::vector<std::size_t> kept;
  if (points <= most) {
    kept.resize(points);
    std::iota(kept.begin(), kept.end(), 0U);
    return kept;
  }
  const std::size_t pieces = std::max<std::size_t>(1, most / (2 * curves.size() + 2));
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    const std::size_t first = piece * points / pieces, last = (piece + 1) * points / pieces;
    kept.push_back(first);
    for (const std::vector<double>& curve : curves) add_extremes(curve, first, last, kept);
    kept.push_back(last - 1);
  }
  std::ranges::sort(kept);
  kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
  return kept;
}

std::vector<double> picked(const std::vector<double>& values, std::span<const std::size_t> indices) {
  std::vector<double> out;
  for (const std::size_t i : indices) out.push_back(values[i]);
  return out;
}

}  // namespace jointid::report
