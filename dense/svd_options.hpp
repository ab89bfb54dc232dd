#pragma once

#include "dense/svd.hpp"

namespace jointid::dense {

/// The bits by which Eigen's SVD classes are asked for vectors.
inline unsigned int svd_options(Vectors u, Vectors v) {
  const auto bits = [](Vectors which, int thin, int full) { return which == Vectors::none ? 0 : which == Vectors::thin ? thin : full; };
  return static_cast<unsigned int>(bits(u, Eigen::ComputeThinU, Eigen::ComputeFullU) | bits(v, Eigen::ComputeThinV, Eigen::ComputeFullV));
}

/// What an SVD class of Eigen found.
template <class Matrix, class Decomposition>
Svd<Matrix> svd_parts(const Decomposition& found, Vectors u, Vectors v) {
  Svd<Matrix> out;
  if (u != Vectors::none) out.u = found.matrixU();
  out.sigma = found.singularValues();
  if (v != Vectors::none) out.v = found.matrixV();
  return out;
}

}  // namespace jointid::dense
