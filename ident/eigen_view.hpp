#pragma once

#include <Eigen/Core>

#include "ident/line_product.hpp"

namespace jointid::ident {

using RowMatrixXc = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

using RowMatrixXd = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A View as an Eigen matrix.
inline Eigen::Map<const RowMatrixXc, 0, Eigen::OuterStride<>> map(const View& view) {
  return {view.data, static_cast<Eigen::Index>(view.rows), static_cast<Eigen::Index>(view.columns),
          Eigen::OuterStride<>(static_cast<Eigen::Index>(view.stride))};
}

}  // namespace jointid::ident
