#include "oscillation/delay/false_neighbours.hpp"

#include <cmath>

#include "oscillation/delay/checked_series.hpp"
#include "oscillation/delay/embedding.hpp"
#include "oscillation/delay/neighbours.hpp"

namespace jointid::oscillation {
namespace {

FalseNeighbours in_dimension(std::span<const double> x, std::size_t d, double sigma, const FalseNeighbourOptions& options) {
  const std::size_t count = x.size() - d * options.delay;
  const RowMatrixXd points = delay_points(x, {d, options.delay}, count);
  const Neighbours neighbours(points, options.theiler);
  FalseNeighbours out{d, count};
  std::size_t tested = 0, ratio = 0, size = 0, either = 0, squared = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const auto near = neighbours.nearest(i, count);
    if (!near) continue;
    const double increase = std::abs(x[i + d * options.delay] - x[near->index + d * options.delay]);
    const bool by_ratio = increase / near->distance > options.ratio;
    const bool by_size = std::hypot(near->distance, increase) > options.size * sigma;
    tested += 1;
    ratio += by_ratio;
    size += by_size;
    either += by_ratio || by_size;
    squared += std::pow(increase / near->distance, 2) > options.ratio;
  }
  const double all = static_cast<double>(std::max<std::size_t>(tested, 1));
  out.ratio = static_cast<double>(ratio) / all;
  out.size = static_cast<double>(size) / all;
  out.either = static_cast<double>(either) / all;
  out.squared_ratio = static_cast<double>(squared) / all;
  return out;
}

}  // namespace

std::vector<FalseNeighbours> false_neighbours(std::span<const double> x, const FalseNeighbourOptions& options) {
  if (options.delay == 0) wrong_option("delay", "is 0");
  if (options.most_dimension == 0) wrong_option("most_dimension", "is 0");
  if (!(options.ratio > 0.0)) wrong_option("ratio", "is not above 0");
  if (!(options.size > 0.0)) wrong_option("size", "is not above 0");
  check_series(x, options.most_dimension * options.delay + 2);
  const double sigma = deviation(x);
  std::vector<FalseNeighbours> rows;
  for (std::size_t d = 1; d <= options.most_dimension; ++d) rows.push_back(in_dimension(x, d, sigma, options));
  return rows;
}

}  // namespace jointid::oscillation
