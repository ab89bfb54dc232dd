#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace jointid::friction {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A place or a size, as Eigen counts them.
inline Eigen::Index at(std::size_t i) { return static_cast<Eigen::Index>(i); }

}  // namespace jointid::friction
