#include "ident/admissible/interior_block.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/eigen.hpp"
#include "dense/cholesky.hpp"
#include "dense/eigen.hpp"

namespace jointid::ident {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double drift = 1e-9;  ///< of S(x) − S that steps leave when the start is made good, elements near 1

MatrixXd symmetric_part(const MatrixXd& m) { return 0.5 * (m + m.transpose()); }

/// The lower Cholesky factor; false when the matrix is not positive definite.
bool factored(const MatrixXd& matrix, MatrixXd& root) {
  auto found = dense::cholesky(matrix);
  if (found) root = std::move(*found);
  return found.has_value();
}

double room_of(const MatrixXd& root, const MatrixXd& step) {
  const auto lower = root.triangularView<Eigen::Lower>();
  const MatrixXd half = lower.solve(step);
  const double least = least_eigenvalue(symmetric_part(lower.solve(MatrixXd(half.transpose()))));
  return least >= -0.95 ? 1.0 / 0.95 : -1.0 / least;
}

}  // namespace

InteriorBlock::InteriorBlock(const SymmetricBlock& block, const VectorXd& origin, const MatrixXd& basis)
    : scale_(balance(block, origin)), of_(scaled(block, scale_)), at_origin_(of_.at(origin)) {
  basis_.resize(at(of_.unknowns.size()), basis.cols());
  for (Index u = 0; u < basis_.rows(); ++u) basis_.row(u) = basis.row(of_.unknowns[static_cast<std::size_t>(u)]);
  std::iota(of_.unknowns.begin(), of_.unknowns.end(), Index{0});
  violation_ = std::max(0.0, -least_eigenvalue(at_origin_));
  for (Index j = 0; j < basis.cols(); ++j) sensitivity_ = std::max(sensitivity_, along(VectorXd::Unit(basis.cols(), j)).norm());
  sensitivity_ = std::min(sensitivity_, std::max(1.0, at_origin_.norm()));
}

MatrixXd InteriorBlock::along(const VectorXd& x) const { return of_.linear_part(basis_ * x); }

VectorXd InteriorBlock::adjoint(const MatrixXd& y) const {
  VectorXd sum = VectorXd::Zero(basis_.rows());
  of_.add_adjoint(y, sum);
  return basis_.transpose() * sum;
}

void InteriorBlock::begin(double mu) {
  const dense::SymmetricEigen eigen = dense::symmetric_eigen(at_origin_);
  const double least = std::max({violation_, sensitivity_, 1e-13 * at_origin_.norm()});
  const VectorXd values = eigen.values.cwiseMax(least);
  s_ = eigen.vectors * values.asDiagonal() * eigen.vectors.transpose();
  lambda_ = eigen.vectors * (mu * values.cwiseInverse()).asDiagonal() * eigen.vectors.transpose();
}

bool InteriorBlock::factor(const VectorXd& x) {
  missing_ = at_origin_ + along(x) - s_;
  if (missing() <= drift && factored(s_ + missing_, s_root_)) {
    s_ += missing_;  // what many steps have rounded
    missing_.setZero();
  }
  if (!factored(s_, s_root_) || !factored(lambda_, lambda_root_)) return false;
  const MatrixXd half = s_root_.triangularView<Eigen::Lower>().solve(MatrixXd::Identity(size(), size()));
  s_inverse_ = half.transpose() * half;
  return s_inverse_.allFinite();
}

void InteriorBlock::add_curvature(MatrixXd& to) const {
  MatrixXd inner(basis_.rows(), basis_.rows());
  MatrixXd product(size(), size());
  for (Index v = 0; v < inner.cols(); ++v) {
    product.setZero();
    for (const auto& [row, column, value] : of_.coefficients[static_cast<std::size_t>(v)]) {
      product.noalias() += value * s_inverse_.col(row) * lambda_.row(column);
    }
    for (Index u = 0; u <= v; ++u) {
      double sum = 0.0;
      for (const auto& [row, column, value] : of_.coefficients[static_cast<std::size_t>(u)]) sum += value * product(row, column);
      inner(u, v) = inner(v, u) = sum;
    }
  }
  to += basis_.transpose() * inner * basis_;
}

VectorXd InteriorBlock::pull(double sigma_mu, bool second_order) const {
  MatrixXd sum = sigma_mu * s_inverse_ - symmetric_part(s_inverse_ * missing_ * lambda_);
  if (second_order) sum -= symmetric_part(s_inverse_ * ds_ * d_lambda_);
  return adjoint(sum);
}

void InteriorBlock::direct(const VectorXd& dx, double sigma_mu, bool second_order) {
  const MatrixXd bent = second_order ? symmetric_part(s_inverse_ * ds_ * d_lambda_) : MatrixXd(MatrixXd::Zero(size(), size()));
  ds_ = along(dx) + missing_;
  d_lambda_ = sigma_mu * s_inverse_ - lambda_ - symmetric_part(s_inverse_ * ds_ * lambda_) - bent;
}

double InteriorBlock::room() const { return std::min(room_of(s_root_, ds_), room_of(lambda_root_, d_lambda_)); }

double InteriorBlock::gap_after(double length) const {
  return (s_ + length * ds_).cwiseProduct(lambda_ + length * d_lambda_).sum();
}

void InteriorBlock::advance(double length) {
  s_ = symmetric_part(s_ + length * ds_);
  lambda_ = symmetric_part(lambda_ + length * d_lambda_);
}

MatrixXd InteriorBlock::value(const VectorXd& x) const {
  const VectorXd back = scale_.cwiseInverse();
  return back.asDiagonal() * (at_origin_ + along(x)) * back.asDiagonal();
}

MatrixXd InteriorBlock::multiplier() const { return scale_.asDiagonal() * lambda_ * scale_.asDiagonal(); }

Index InteriorBlock::at_limit() const {
  const dense::SymmetricEigen eigen = dense::symmetric_eigen(s_);
  Index count = 0;
  for (Index i = 0; i < size(); ++i) {
    const VectorXd direction = eigen.vectors.col(i);
    count += eigen.values[i] < sensitivity_ * sensitivity_ * direction.dot(lambda_ * direction) ? 1 : 0;
  }
  return count;
}

}  // namespace jointid::ident
