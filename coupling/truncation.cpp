#include "coupling/truncation.hpp"

#include <algorithm>

#include "dense/svd.hpp"

namespace jointid::coupling {
namespace {

constexpr double told_apart = 3.0;  ///< standard deviations
constexpr double growth = 3.0;      ///< of the forces from one singular value to the next

using Svd = dense::ComplexSvd;

Svd decompose(const MatrixRef& s) { return dense::svd(s, dense::Vectors::thin, dense::Vectors::thin); }

/// Keeps the singular values up to the first that is not above limit(i, σ).
template <class Limit>
Truncation keep(const Svd& svd, Limit limit) {
  Truncation out;
  out.sigma = svd.sigma;
  out.limit = Eigen::VectorXd::Zero(out.sigma.size());
  for (; out.kept < out.sigma.size(); ++out.kept) {
    out.limit[out.kept] = limit(out.kept, out.sigma);
    if (!(out.sigma[out.kept] > out.limit[out.kept])) break;
  }
  const Index k = out.kept;
  const Eigen::VectorXcd inverse = out.sigma.head(k).cwiseInverse().cast<Complex>();
  out.inverse = svd.v.leftCols(k) * inverse.asDiagonal() * svd.u.leftCols(k).adjoint();
  return out;
}

}  // namespace

Truncation truncate_fixed(const MatrixRef& s, double epsilon) {
  return keep(decompose(s), [&](Index, const Eigen::VectorXd& sigma) { return epsilon * sigma[0]; });
}

Truncation truncate_noise(const MatrixRef& s, const Eigen::Ref<const Eigen::MatrixXd>& variance) {
  const Svd svd = decompose(s);
  return keep(svd, [&](Index i, const Eigen::VectorXd&) {
    const Eigen::VectorXd u = svd.u.col(i).cwiseAbs2(), v = svd.v.col(i).cwiseAbs2();
    return told_apart * std::sqrt(u.dot(variance * v));
  });
}

Truncation truncate_picard(const MatrixRef& s, const MatrixRef& y) {
  const Svd svd = decompose(s);
  const Eigen::VectorXd parts = (svd.u.adjoint() * y).rowwise().norm();
  double largest = 0.0;
  return keep(svd, [&](Index i, const Eigen::VectorXd& sigma) {
    const double limit = i == 0 || parts[i] == 0.0 ? 0.0 : parts[i] / (growth * largest);
    largest = std::max(largest, parts[i] / sigma[i]);
    return limit;
  });
}

}  // namespace jointid::coupling
