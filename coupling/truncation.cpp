#include "coupling/truncation.hpp"

#include <Eigen/SVD>
#include <algorithm>

namespace jointid::coupling {
namespace {

constexpr double told_apart = 3.0;  ///< standard deviations
constexpr double growth = 3.0;      ///< of the forces from one singular value to the next

using Svd = Eigen::BDCSVD<ComplexMatrix>;

Svd decompose(const MatrixRef& s) { return Svd(s, Eigen::ComputeThinU | Eigen::ComputeThinV); }

/// The first k singular values.
Truncation keep(const Svd& svd, Index k) {
  Truncation out;
  out.sigma = svd.singularValues();
  out.kept = k;
  out.threshold = k < out.sigma.size() ? out.sigma[k] : 0.0;
  const Eigen::VectorXcd inverse = out.sigma.head(k).cwiseInverse().cast<Complex>();
  out.inverse = svd.matrixV().leftCols(k) * inverse.asDiagonal() * svd.matrixU().leftCols(k).adjoint();
  return out;
}

}  // namespace

Truncation truncate_fixed(const MatrixRef& s, double epsilon) {
  const Svd svd = decompose(s);
  Index k = 0;
  while (k < s.rows() && svd.singularValues()[k] > epsilon * svd.singularValues()[0]) ++k;
  return keep(svd, k);
}

Truncation truncate_noise(const MatrixRef& s, const Eigen::Ref<const Eigen::MatrixXd>& variance) {
  const Svd svd = decompose(s);
  Index k = 0;
  for (; k < s.rows(); ++k) {
    const Eigen::VectorXd u = svd.matrixU().col(k).cwiseAbs2(), v = svd.matrixV().col(k).cwiseAbs2();
    if (!(svd.singularValues()[k] > told_apart * std::sqrt(u.dot(variance * v)))) break;
  }
  return keep(svd, k);
}

Truncation truncate_picard(const MatrixRef& s, const MatrixRef& y) {
  const Svd svd = decompose(s);
  const Eigen::VectorXd parts = (svd.matrixU().adjoint() * y).rowwise().norm();
  double largest = 0.0;
  Index k = 0;
  for (; k < s.rows() && svd.singularValues()[k] > 0.0; ++k) {
    const double force = parts[k] / svd.singularValues()[k];
    if (k > 0 && force > growth * largest) break;
    largest = std::max(largest, force);
  }
  return keep(svd, k);
}

}  // namespace jointid::coupling
