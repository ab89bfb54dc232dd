#pragma once

#include <Eigen/Core>

#include "base/eigen.hpp"
#include "ident/algebra/line_product.hpp"

namespace jointid::ident {

/// A View as an Eigen matrix.
inline Eigen::Map<const RowMatrixXc, 0, Eigen::OuterStride<>> map(const View& view) {
  return {view.data, at(view.rows), at(view.columns),
          Eigen::OuterStride<>(at(view.stride))};
}

}  // namespace jointid::ident
