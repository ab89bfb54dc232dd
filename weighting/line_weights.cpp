#include "weighting/line_weights.hpp"

#include <algorithm>
#include <array>

namespace jointid::weighting {
namespace {

double reciprocal(double value) { return value > 0.0 ? 1.0 / value : 0.0; }

bool in_use(const LineShape& shape, std::size_t m, std::size_t l) {
  return shape.keep.empty() || shape.keep[m * shape.column_max.size() + l] != 0;
}

double largest_coefficient(const LineShape& shape) {
  if (shape.keep.empty()) {
    return *std::max_element(shape.row_max.begin(), shape.row_max.end()) *
           *std::max_element(shape.column_max.begin(), shape.column_max.end());
  }
  double largest = 0.0;
  for (std::size_t m = 0; m < shape.row_max.size(); ++m) {
    for (std::size_t l = 0; l < shape.column_max.size(); ++l) {
      if (in_use(shape, m, l)) largest = std::max(largest, shape.row_max[m] * shape.column_max[l]);
    }
  }
  return largest;
}

/// Largest column_max over the equations of class 0 and 1 that row m has in use.
std::array<double, 2> group_max(const LineShape& shape, std::size_t m) {
  std::array<double, 2> largest{};
  for (std::size_t l = 0; l < shape.column_max.size(); ++l) {
    double& group = largest[shape.column_class[l]];
    if (in_use(shape, m, l)) group = std::max(group, shape.column_max[l]);
  }
  return largest;
}

void weigh_groups(const LineShape& shape, LineWeights& weights) {
  const std::size_t rows = shape.row_max.size();
  if (shape.keep.empty()) {
    const std::array<double, 2> largest = group_max(shape, 0);
    for (std::size_t m = 0; m < rows; ++m) weights.row[m] = weights.row[rows + m] = reciprocal(shape.row_max[m]);
    for (std::size_t l = 0; l < weights.column.size(); ++l) {
      weights.column[l] = reciprocal(largest[shape.column_class[l]]);
    }
    return;
  }
  for (std::size_t m = 0; m < rows; ++m) {
    const std::array<double, 2> largest = group_max(shape, m);
    for (std::size_t k = 0; k < 2; ++k) weights.row[k * rows + m] = reciprocal(shape.row_max[m] * largest[k]);
  }
}

}  // namespace

void line_weights(Weighting weighting, const LineShape& shape, LineWeights& weights) {
  const std::size_t rows = shape.row_max.size();
  weights.row.assign(2 * rows, 1.0);
  weights.column.assign(shape.column_max.size(), 1.0);
  switch (weighting) {
    case Weighting::none:
    case Weighting::wa:
      return;
    case Weighting::wb:
      std::fill(weights.row.begin(), weights.row.end(), reciprocal(largest_coefficient(shape)));
      return;
    case Weighting::wbg:
      weigh_groups(shape, weights);
      return;
    case Weighting::wbs:
      for (std::size_t m = 0; m < rows; ++m) weights.row[m] = weights.row[rows + m] = reciprocal(shape.row_max[m]);
      for (std::size_t l = 0; l < weights.column.size(); ++l) weights.column[l] = reciprocal(shape.column_max[l]);
      return;
  }
}

}  // namespace jointid::weighting
