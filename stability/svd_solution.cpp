#include "stability/svd_solution.hpp"

#include <limits>

#include "base/eigen.hpp"
#include "dense/svd.hpp"
#include "minimise/linear/column_scaling.hpp"

namespace jointid::stability {

minimise::LinearSolution solve_svd(minimise::Accumulator& accumulator) {
  accumulator.flush();
  const std::size_t n = accumulator.columns();
  std::size_t rows = 0;
  for (const auto& [columns, triangle] : accumulator.triangles()) rows += columns.size() + 1;
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(at(rows), at(n));
  Eigen::VectorXd right = Eigen::VectorXd::Zero(system.rows());
  Eigen::Index row = 0;
  for (const auto& [columns, triangle] : accumulator.triangles()) {
    for (std::size_t i = 0; i <= columns.size(); ++i, ++row) {
      for (std::size_t j = i; j < columns.size(); ++j) system(row, at(columns[j])) = triangle(i, j);
      right[row] = triangle(i, columns.size());
    }
  }
  const Eigen::VectorXd scale = minimise::power_of_two_scales(system);
  const dense::RealSvd svd = dense::jacobi_svd(system * scale.asDiagonal(), dense::Vectors::thin, dense::Vectors::thin);
  const double threshold = 16.0 * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
  const Eigen::Index rank = (svd.sigma.array() > threshold * svd.sigma[0]).count();
  const Eigen::VectorXd parts = (svd.u.leftCols(rank).transpose() * right).cwiseQuotient(svd.sigma.head(rank));
  const Eigen::VectorXd y = scale.asDiagonal() * (svd.v.leftCols(rank) * parts);
  minimise::LinearSolution out;
  out.y.assign(y.begin(), y.end());
  out.rank = static_cast<std::size_t>(rank);
  const double least = svd.sigma[svd.sigma.size() - 1];
  out.condition = least > 0.0 ? svd.sigma[0] / least : std::numeric_limits<double>::infinity();
  out.residual_norm = (system * y - right).norm();
  return out;
}

}  // namespace jointid::stability
