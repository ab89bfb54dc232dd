#include "oscillation/delay/plateau.hpp"

#include <algorithm>
#include <cmath>

#include "oscillation/delay/checked_series.hpp"

namespace jointid::oscillation {
namespace {

std::optional<Plateau> judged(std::span<const double> x, std::span<const double> y, std::size_t first, std::size_t count,
                              const PlateauOptions& options) {
  const auto part = [&](std::span<const double> v, std::size_t begin, std::size_t n) { return v.subspan(first + begin, n); };
  if (!std::ranges::all_of(part(y, 0, count), [](double value) { return std::isfinite(value); })) return std::nullopt;
  Plateau found{line_slope(part(x, 0, count), part(y, 0, count)), 0.0, first, first + count - 1};
  const double rise = found.slope * (x[found.last] - x[first]);
  if (!(rise >= options.least_rise)) return std::nullopt;
  const std::size_t third = count / 3;
  for (const std::size_t begin : {std::size_t{0}, (count - third) / 2, count - third}) {
    found.spread = std::max(found.spread, std::abs(line_slope(part(x, begin, third), part(y, begin, third)) - found.slope));
  }
  if (found.spread > options.tolerance * found.slope) return std::nullopt;
  return found;
}

}  // namespace

double line_slope(std::span<const double> x, std::span<const double> y) {
  const double n = static_cast<double>(x.size());
  double mx = 0.0, my = 0.0, sxx = 0.0, sxy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) mx += x[i] / n, my += y[i] / n;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sxx += (x[i] - mx) * (x[i] - mx);
    sxy += (x[i] - mx) * (y[i] - my);
  }
  return sxy / sxx;
}

std::optional<Plateau> find_plateau(std::span<const double> x, std::span<const double> y, const PlateauOptions& options) {
  if (options.least_points < 6) wrong_option("least_points", "is below 6");
  if (x.size() != y.size()) wrong_option("curve", std::to_string(x.size()) + " x and " + std::to_string(y.size()) + " y");
  for (std::size_t count = x.size(); count >= options.least_points; --count) {
    std::optional<Plateau> best;
    for (std::size_t first = 0; first + count <= x.size(); ++first) {
      const auto found = judged(x, y, first, count, options);
      if (found && (!best || found->spread < best->spread)) best = found;
    }
    if (best) return best;
  }
  return std::nullopt;
}

}  // namespace jointid::oscillation
