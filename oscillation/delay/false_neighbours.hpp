#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace jointid::oscillation {

/// Kennel, Brown & Abarbanel 1992. A neighbour is false in d dimensions when the coordinate x_{i+dT} takes it far away.
struct FalseNeighbourOptions {
  std::size_t delay = 1;            ///< T ≥ 1, samples
  std::size_t most_dimension = 10;  ///< d = 1 … this
  std::size_t theiler = 0;          ///< neighbours are |i − j| > this; flows need about a correlation time
  double ratio = 10.0;              ///< > 0: false when |x_{i+dT} − x_{j+dT}|/D is above
  double size = 2.0;                ///< > 0: or √(D² + increase²)/σ is above; σ of the whole series
};

/// Fractions of the points that have a neighbour at distance D > 0.
struct FalseNeighbours {
  std::size_t dimension = 0, points = 0;  ///< i = 0 … n − dT − 1
  double ratio = 0.0;                     ///< false by the first criterion
  double size = 0.0;                      ///< by the second
  double either = 0.0;                    ///< by either: Kennel's test
  double squared_ratio = 0.0;  ///< (increase/D)² above `ratio`: (3.24) of Kappagantu as printed, which is another test
};

/// A row a dimension. Throws InputError when the series is too short for the largest one.
std::vector<FalseNeighbours> false_neighbours(std::span<const double> x, const FalseNeighbourOptions& options = {});

}  // namespace jointid::oscillation
