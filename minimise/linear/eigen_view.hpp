#pragma once

#include <Eigen/Core>

#include "base/eigen.hpp"
#include "minimise/linear/line_product.hpp"

namespace jointid::minimise {

/// A View as an Eigen matrix.
inline Eigen::Map<const RowMatrixXc, 0, Eigen::OuterStride<>> map(const View& view) {
  return {view.data, at(view.rows), at(view.columns), Eigen::OuterStride<>(at(view.stride))};
}

}  // namespace jointid::minimise
