#include "oscillation/delay/embedding.hpp"

#include <algorithm>

#include "oscillation/delay/checked_series.hpp"

namespace jointid::oscillation {

RowMatrixXd delay_points(std::span<const double> x, const Embedding& embedding, std::size_t count) {
  if (embedding.dimension == 0) wrong_option("dimension", "is 0");
  if (embedding.delay == 0) wrong_option("delay", "is 0");
  const std::size_t last = (embedding.dimension - 1) * embedding.delay;
  check_series(x, last + std::max<std::size_t>(count, 1));
  const std::size_t rows = count > 0 ? count : x.size() - last;
  RowMatrixXd points(at(rows), at(embedding.dimension));
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t k = 0; k < embedding.dimension; ++k) points(at(i), at(k)) = x[i + k * embedding.delay];
  }
  return points;
}

}  // namespace jointid::oscillation
