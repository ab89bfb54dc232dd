#include "modalfit/band/normal_block.hpp"

#include "base/eigen.hpp"
#include "dense/cholesky.hpp"
#include "dense/gram.hpp"

namespace jointid::modalfit {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double ridge = 1e-12;
/// Below this share of the FRF the residual shows the ridge and the rounding of the normal equations.
constexpr double shows_rounding = 1e-6;
constexpr int corrections = 3;

std::size_t count(Index n) { return static_cast<std::size_t>(n); }

/// AᵀB of tall matrices.
MatrixXd cross_of(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd out = MatrixXd::Zero(a.cols(), b.cols());
  dense::add_cross(a.data(), count(a.cols()), b.data(), count(b.cols()), count(a.rows()), out.data());
  return out;
}

/// AᵀA, the lower triangle.
MatrixXd gram_of(const MatrixXd& a) {
  MatrixXd out = MatrixXd::Zero(a.cols(), a.cols());
  dense::add_gram(a.data(), count(a.rows()), count(a.cols()), count(a.rows()), out.data());
  return out;
}

MatrixXd real_rows(const std::vector<std::complex<double>>& columns, std::size_t lines) {
  const auto* parts = reinterpret_cast<const double*>(columns.data());
  return Eigen::Map<const MatrixXd>(parts, static_cast<Index>(2 * lines), static_cast<Index>(columns.size() / lines));
}

}  // namespace

RealBasis::RealBasis(const Basis& basis)
    : columns(real_rows(basis.columns, basis.lines)),
      derivatives(real_rows(basis.derivatives, basis.lines)),
      modes(at(basis.modes)),
      per_mode(at(basis.per_mode)) {}

NormalBlock::NormalBlock(const RealBasis& basis, const Band& band, std::size_t entry) {
  band.look();
  const Index rows = basis.columns.rows(), size = basis.columns.cols();
  weight_ = Eigen::Map<const VectorXd>(band.weights(entry), rows);
  equations_ = static_cast<double>((weight_.array() > 0.0).count());
  weighted_ = weight_.asDiagonal() * basis.columns;
  const VectorXd y =
      weight_.cwiseProduct(Eigen::Map<const VectorXd>(reinterpret_cast<const double*>(band.value(entry)), rows));
  MatrixXd normal = gram_of(weighted_);
  scale_ = normal.diagonal().cwiseSqrt().cwiseInverse();
  for (double& scale : scale_) scale = std::isfinite(scale) ? scale : 0.0;
  normal = (scale_.asDiagonal() * normal.selfadjointView<Eigen::Lower>().toDenseMatrix() * scale_.asDiagonal()).eval();
  for (Index i = 0; i < size; ++i) normal(i, i) = scale_(i) > 0.0 ? 1.0 + ridge : 1.0;
  dense::cholesky_in_place(normal);
  factor_ = normal;
  coefficients_ = solve(weighted_.transpose() * y);
  residual_ = y - weighted_ * coefficients_;
  cost_ = residual_.squaredNorm();
  if (cost_ < shows_rounding * shows_rounding * y.squaredNorm()) correct(y);
}

/// Corrected semi-normal equations (Björck 1987): as exact as an orthogonal factorisation.
void NormalBlock::correct(const VectorXd& y) {
  for (int i = 0; i < corrections; ++i) {
    const VectorXd coefficients = coefficients_ + solve(weighted_.transpose() * residual_);
    const VectorXd residual = y - weighted_ * coefficients;
    if (!(residual.squaredNorm() < cost_)) return;
    coefficients_ = coefficients;
    residual_ = residual;
    cost_ = residual.squaredNorm();
  }
}

MatrixXd NormalBlock::solve(const MatrixXd& right) const {
  MatrixXd out = scale_.asDiagonal() * right;
  dense::solve_lower(factor_, out);
  dense::solve_lower_transposed(factor_, out);
  return scale_.asDiagonal() * out;
}

MatrixXd NormalBlock::weighted_slopes(const RealBasis& basis) const {
  MatrixXd d(basis.columns.rows(), 2 * basis.modes);
  for (Index mode = 0; mode < basis.modes; ++mode) {
    for (Index parameter = 0; parameter < 2; ++parameter) {
      const Index first = (2 * mode + parameter) * basis.per_mode;
      d.col(2 * mode + parameter).noalias() =
          basis.derivatives.middleCols(first, basis.per_mode) * coefficients_.segment(mode * basis.per_mode, basis.per_mode);
    }
  }
  return weight_.asDiagonal() * d;
}

MatrixXd NormalBlock::pole_rows(const RealBasis& basis) const {
  MatrixXd d = weighted_slopes(basis);
  d.noalias() -= weighted_ * solve(cross_of(weighted_, d));
  return d;
}

NormalBlock::PoleTerms NormalBlock::pole_terms(const RealBasis& basis) const {
  const MatrixXd d = weighted_slopes(basis);
  PoleTerms terms;
  terms.cross = cross_of(weighted_, d);
  terms.gradient.noalias() = d.transpose() * residual_;
  terms.curvature = gram_of(d).selfadjointView<Eigen::Lower>();
  terms.curvature.noalias() -= terms.cross.transpose() * solve(terms.cross);
  return terms;
}

}  // namespace jointid::modalfit
