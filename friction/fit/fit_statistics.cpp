#include "friction/fit/fit_statistics.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

#include "base/eigen.hpp"
#include "dense/qr.hpp"
#include "dense/svd.hpp"

namespace jointid::friction {

FitStatistics::FitStatistics(const minimise::LeastSquares& problem, std::span<const double> q) {
  const std::size_t rows = problem.residuals(), unknowns = problem.unknowns();
  std::vector<double> r(rows), numbers(rows * unknowns);
  problem.evaluate(q, r, numbers);
  for (const double each : r) sum_ += each * each;
  const double freedom = static_cast<double>(rows - unknowns);
  std_ = std::sqrt(sum_ / freedom);
  quantile_ = boost::math::quantile(boost::math::students_t(freedom), 0.975);
  Eigen::MatrixXd jacobian = Eigen::Map<const RowMatrixXd>(numbers.data(), at(rows), at(unknowns));
  scale_ = jacobian.colwise().norm().transpose();
  scale_ = (scale_.array() > 0.0).select(scale_, 1.0);
  jacobian *= scale_.cwiseInverse().asDiagonal();
  const dense::RealSvd svd = dense::jacobi_svd(dense::triangle_of(jacobian), dense::Vectors::none, dense::Vectors::full);
  const double least = svd.sigma[0] * static_cast<double>(rows) * std::numeric_limits<double>::epsilon();
  const Eigen::Index rank = (svd.sigma.array() > least).count();
  const Eigen::MatrixXd seen = svd.v.leftCols(rank) * svd.sigma.head(rank).cwiseInverse().asDiagonal();
  unseen_ = svd.v.rightCols(at(unknowns) - rank);
  const Eigen::MatrixXd unscaled = scale_.cwiseInverse().asDiagonal() * seen;
  covariance_ = std_ * std_ * unscaled * unscaled.transpose();
}

std::optional<double> FitStatistics::std_error(const Eigen::RowVectorXd& gradient) const {
  constexpr double rounding = 1e-7;
  const Eigen::RowVectorXd scaled = gradient * scale_.cwiseInverse().asDiagonal();
  if ((scaled * unseen_).norm() > rounding * scaled.norm()) return std::nullopt;
  return std::sqrt((gradient * covariance_ * gradient.transpose()).value());
}

double FitStatistics::correlation(std::size_t i, std::size_t j) const {
  const auto unit = [&](std::size_t k) { return Eigen::RowVectorXd::Unit(scale_.size(), at(k)); };
  const auto one = std_error(unit(i)), other = std_error(unit(j));
  if (!one || !other) return std::numeric_limits<double>::quiet_NaN();
  return i == j ? 1.0 : covariance_(at(i), at(j)) / (*one * *other);
}

FittedValue FitStatistics::describe(const Parameter& parameter, const Eigen::RowVectorXd& gradient) const {
  constexpr double rounding = 1e-12;
  if (gradient.norm() <= rounding * std::abs(parameter.value))
    return {parameter.name, parameter.unit, parameter.value, {}, {}, Knowledge::preset};
  return fitted_value(parameter, std_error(gradient), quantile_);
}

}  // namespace jointid::friction
