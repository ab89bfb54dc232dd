#include "oscillation/delay/mutual_information.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "oscillation/delay/checked_series.hpp"

namespace jointid::oscillation {
namespace {

/// The cell of every sample.
std::vector<std::size_t> cells_of(std::span<const double> x, std::size_t cells) {
  const auto [low, high] = std::ranges::minmax(x);
  std::vector<std::size_t> cell(x.size(), 0);
  if (high > low) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double place = static_cast<double>(cells) * ((x[i] - low) / (high - low));
      cell[i] = std::min(cells - 1, static_cast<std::size_t>(place));
    }
  }
  return cell;
}

double information(const std::vector<std::size_t>& cell, std::size_t lag, const InformationOptions& options) {
  const std::size_t n = cell.size(), pairs = options.cyclic ? n : n - lag, cells = options.cells;
  std::vector<double> joint(cells * cells, 0.0), first(cells, 0.0), second(cells, 0.0);
  for (std::size_t i = 0; i < pairs; ++i) {
    const std::size_t a = cell[i], b = cell[(i + lag) % n];
    joint[a * cells + b] += 1.0;
    first[a] += 1.0;
    second[b] += 1.0;
  }
  const double total = static_cast<double>(pairs);
  double bits = 0.0;
  for (std::size_t a = 0; a < cells; ++a) {
    for (std::size_t b = 0; b < cells; ++b) {
      const double count = joint[a * cells + b];
      if (count > 0.0) bits += count / total * std::log2(count * total / (first[a] * second[b]));
    }
  }
  return bits;
}

void check(std::span<const double> x, std::size_t lag, const InformationOptions& options) {
  check_series(x, options.cyclic ? 1 : lag + 1);
  if (options.cells == 0 || options.cells > 4096)
    wrong_option("cells", std::to_string(options.cells) + " is not between 1 and 4096");
}

}  // namespace

double mutual_information(std::span<const double> x, std::size_t lag, const InformationOptions& options) {
  check(x, lag, options);
  return information(cells_of(x, options.cells), lag, options);
}

double information_bias(std::size_t cells, std::size_t pairs) {
  const double free = static_cast<double>(cells) - 1.0;
  return free * free / (2.0 * static_cast<double>(pairs) * std::numbers::ln2);
}

InformationCurve information_curve(std::span<const double> x, std::size_t most_lag, const InformationOptions& options) {
  check(x, most_lag, options);
  const std::vector<std::size_t> cell = cells_of(x, options.cells);
  InformationCurve curve;
  for (std::size_t lag = 0; lag <= most_lag; ++lag) curve.bits.push_back(information(cell, lag, options));
  curve.first_minimum = first_minimum(curve.bits);
  return curve;
}

std::optional<std::size_t> first_minimum(std::span<const double> curve) {
  for (std::size_t i = 1; i + 1 < curve.size(); ++i) {
    if (curve[i] < curve[i - 1] && curve[i] <= curve[i + 1]) return i;
  }
  return std::nullopt;
}

}  // namespace jointid::oscillation
