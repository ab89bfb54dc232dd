#include "modalfit/model/rank_one.hpp"

#include <cmath>
#include <limits>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "dense/cholesky.hpp"
#include "dense/svd.hpp"

namespace jointid::modalfit {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

constexpr int most_iterations = 100;

double cost_of(const std::vector<RankOneDatum>& data, const VectorXcd& phi) {
  double cost = 0.0;
  for (const RankOneDatum& datum : data) cost += datum.weight * std::norm(datum.value - phi(at(datum.row)) * phi(at(datum.column)));
  return cost;
}

/// First singular vectors of the elements as measured, u on rows and v on columns, brought to one scale where a coordinate is both.
VectorXcd start(const std::vector<RankOneDatum>& data, Index size, bool real) {
  MatrixXcd matrix = MatrixXcd::Zero(size, size);
  Eigen::VectorXi rows = Eigen::VectorXi::Zero(size), columns = rows;
  for (const RankOneDatum& datum : data) {
    matrix(at(datum.row), at(datum.column)) = datum.value;
    rows(at(datum.row)) = columns(at(datum.column)) = 1;
  }
  const dense::ComplexSvd svd = dense::svd(matrix, dense::Vectors::thin, dense::Vectors::thin);
  const VectorXcd u = svd.u.col(0), v = svd.v.col(0).conjugate();
  Complex both = 0.0;
  double square = 0.0;
  for (Index i = 0; i < size; ++i) {
    if (rows(i) == 0 || columns(i) == 0) continue;
    both += std::conj(v(i)) * u(i);
    square += std::norm(v(i));
  }
  const Complex ratio = std::abs(both) > 0.0 && square > 0.0 ? both / square : Complex(1.0);  // u = ratio·v
  Complex scale = std::sqrt(svd.sigma(0) / ratio);
  if (real) scale = std::sqrt(svd.sigma(0) / std::abs(ratio));
  VectorXcd phi(size);
  for (Index i = 0; i < size; ++i) phi(i) = rows(i) ? scale * u(i) : scale * ratio * v(i);
  if (real) {
    Index largest = 0;
    phi.cwiseAbs().maxCoeff(&largest);
    if (std::abs(phi(largest)) > 0.0) phi *= std::abs(phi(largest)) / phi(largest);
    phi = phi.real().cast<Complex>();
  }
  return phi;
}

/// Normal matrix JᴴWJ and JᴴW(value − φφᵀ).
void normal_equations(const std::vector<RankOneDatum>& data, const VectorXcd& phi, MatrixXcd& normal, VectorXcd& right) {
  normal.setZero();
  right.setZero();
  for (const RankOneDatum& datum : data) {
    const Index i = at(datum.row), j = at(datum.column);
    const Complex by_i = phi(j), by_j = phi(i);  // both add up on the diagonal
    const Complex rest = datum.weight * (datum.value - phi(i) * phi(j));
    right(i) += std::conj(by_i) * rest;
    right(j) += std::conj(by_j) * rest;
    normal(i, i) += datum.weight * std::norm(by_i);
    normal(j, j) += datum.weight * std::norm(by_j);
    normal(i, j) += datum.weight * std::conj(by_i) * by_j;
    normal(j, i) += datum.weight * std::conj(by_j) * by_i;
  }
}

MatrixXcd inverse_of(MatrixXcd normal) {
  for (Index i = 0; i < normal.rows(); ++i) {
    if (normal(i, i).real() == 0.0) normal(i, i) = std::numeric_limits<double>::infinity();
  }
  const Eigen::VectorXd scale = normal.diagonal().real().cwiseSqrt().cwiseInverse();
  MatrixXcd scaled = scale.asDiagonal() * normal * scale.asDiagonal();
  for (Index i = 0; i < scaled.rows(); ++i) {
    if (scale(i) == 0.0) {
      scaled.row(i).setZero();
      scaled.col(i).setZero();
    }
    scaled(i, i) = 1.0 + 1e-12;
  }
  return scale.asDiagonal() * dense::solve_positive(scaled, MatrixXcd::Identity(scaled.rows(), scaled.cols())) * scale.asDiagonal();
}

}  // namespace

RankOne fit_rank_one(const std::vector<RankOneDatum>& data, std::size_t size, bool real) {
  const Index n = at(size);
  VectorXcd phi = start(data, n, real);
  MatrixXcd normal(n, n), covariance;
  VectorXcd right(n);
  double cost = cost_of(data, phi), mu = 0.0;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    normal_equations(data, phi, normal, right);
    if (real) right = right.real().cast<Complex>();
    MatrixXcd damped = normal;
    damped.diagonal() *= 1.0 + mu;
    const VectorXcd step = inverse_of(damped) * right;
    const double next = cost_of(data, phi + step);
    const bool small = step.norm() <= 1e-12 * phi.norm();
    if (next <= cost) {
      phi += step;
      cost = next;
      mu *= 0.1;
    } else {
      mu = std::max(1e-3, 10.0 * mu);
    }
    if (small || mu > 1e10) break;
  }
  normal_equations(data, phi, normal, right);
  covariance = inverse_of(normal);
  Index largest = 0;
  if (n > 0) phi.cwiseAbs().maxCoeff(&largest);
  if (n > 0 && phi(largest).real() < 0.0) phi = -phi;
  const auto told = static_cast<double>((normal.diagonal().real().array() > 0.0).count());
  const double freedom = static_cast<double>(data.size()) - told;
  RankOne out{{phi.data(), phi.data() + n}, std::vector<Complex>(size * size), freedom > 0.0 ? cost / freedom : std::nan("")};
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) out.covariance[static_cast<std::size_t>(i * n + j)] = covariance(i, j);
  }
  return out;
}

}  // namespace jointid::modalfit
