#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "oscillation/delay/embedding.hpp"
#include "oscillation/delay/plateau.hpp"

namespace jointid::oscillation {

/// C(r): the share of the pairs |i − j| > theiler of points at most r apart (Grassberger & Procaccia 1983), Euclidean. radii
/// ascending. Time is that of all pairs, n²/2.
std::vector<double> correlation_sum(const RowMatrixXd& points, std::size_t theiler, std::span<const double> radii);

/// D₂ = d ln C/d ln r where ln C is a straight line over a factor of e in C at least; empty where it is none.
struct CorrelationDimension {
  std::vector<double> radius, sum;
  std::optional<Plateau> dimension;  ///< slope of ln C over ln r
};

/// `radii` geometrically between 1/1000 of the largest extent of the points and half of it. Sums of fewer than 50 pairs do not
/// count.
CorrelationDimension correlation_dimension(std::span<const double> x, const Embedding& embedding, std::size_t theiler,
                                           std::size_t radii = 40);

}  // namespace jointid::oscillation
