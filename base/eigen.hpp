#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "base/complex.hpp"

namespace jointid {

/// A place or a size, as Eigen counts them.
inline Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }

/// The numbers as a column.
inline Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), at(values.size()));
}

using RowMatrixXd = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using RowMatrixXc = Eigen::Matrix<Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace jointid
