#include "correlation/expansion.hpp"

#include <complex>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "dense/lu.hpp"
#include "dense/svd.hpp"

namespace jointid::correlation {
namespace {

using Eigen::MatrixXcd;

constexpr double smallest = 1e-10;  ///< of the largest singular value, which counts

/// The pseudo-inverse; `rank` gets the number of singular values that count.
MatrixXcd pseudo_inverse(const MatrixXcd& a, Eigen::Index& rank) {
  const dense::ComplexSvd svd = dense::svd(a, dense::Vectors::thin, dense::Vectors::thin);
  rank = (svd.sigma.array() > smallest * svd.sigma.maxCoeff()).count();
  return svd.v.leftCols(rank) * svd.sigma.head(rank).cwiseInverse().asDiagonal() * svd.u.leftCols(rank).adjoint();
}

}  // namespace

MatrixXcd serep(const MatrixXcd& shapes, const Places& b) {
  Eigen::Index rank = 0;
  const MatrixXcd inverse = pseudo_inverse(shapes(b, Eigen::all), rank);
  if (rank == shapes.cols()) return shapes * inverse;
  throw InputError({.kind = ErrorKind::data,
                    .file = "",
                    .place = "SEREP",
                    .problem = std::to_string(shapes.cols()) + " modes are kept, but the coordinates that were measured distinguish " +
                               std::to_string(rank),
                    .remedy = "keep at most as many modes, or measure more coordinates"});
}

MatrixXcd mixed(const MatrixXcd& parent, const MatrixXcd& overlay, const Places& b, Semm way) {
  const MatrixXcd at_b = parent(b, b), difference = at_b - overlay;
  if (!parent.allFinite() || !overlay.allFinite())
    return MatrixXcd::Constant(parent.rows(), parent.cols(), std::numeric_limits<double>::quiet_NaN());
  if (way == Semm::basic) {
    const MatrixXcd inverse = dense::inverse(at_b);
    return parent - parent(Eigen::all, b) * (inverse * difference * inverse) * parent(b, Eigen::all);
  }
  Eigen::Index rank = 0;
  const MatrixXcd left = parent * pseudo_inverse(parent(b, Eigen::all), rank),
                  right = pseudo_inverse(parent(Eigen::all, b), rank) * parent;
  return parent - left * difference * right;
}

}  // namespace jointid::correlation
