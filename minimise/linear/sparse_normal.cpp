#include "minimise/linear/sparse_normal.hpp"

#include <cmath>
#include <random>

#include "base/eigen.hpp"
#include "minimise/linear/rounding.hpp"
#include "minimise/linear/sparse_covariance.hpp"

namespace jointid::minimise {
namespace {

constexpr double largest_condition = 1e6;
constexpr int corrections = 3;

double length(const std::vector<double>& v) { return Eigen::Map<const Eigen::VectorXd>(v.data(), at(v.size())).stableNorm(); }

/// Largest value of ‖f(x)‖ over ‖x‖, from below, of a symmetric f.
template <class Function>
double power_method(std::size_t n, const Function& f) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  std::vector<double> x(n);
  for (double& each : x) each = normal(random);
  double norm = length(x);
  for (int step = 0; step < 8; ++step) {
    for (double& each : x) each /= norm;
    x = f(x);
    norm = length(x);
    if (!(norm > 0.0) || !std::isfinite(norm)) break;
  }
  return norm;
}

}  // namespace

std::optional<LinearSolution> solve_sparse_normal(Accumulator& accumulator, Condition condition, SparseWay way) {
  accumulator.flush();
  const std::size_t n = accumulator.columns();
  const StackedTriangles stacked(accumulator);
  const auto factor = way == SparseWay::cholmod ? cholmod_cholesky() : ldlt_cholesky();
  if (!factor->factorize(normal_matrix(stacked))) return std::nullopt;
  LinearSolution out;
  const double inverse = power_method(n, [&](const std::vector<double>& x) { return factor->solve(x); });
  const double largest = power_method(n, [&](const std::vector<double>& x) { return stacked.transposed(stacked.product(x)); });
  out.condition = std::sqrt(inverse * largest);
  if (!(out.condition < largest_condition)) return std::nullopt;
  out.rank = n;
  out.y = factor->solve(stacked.transposed(stacked.right));
  for (int step = 0; step < corrections; ++step) {
    const std::vector<double> change = factor->solve(stacked.transposed(stacked.residual(out.y)));
    for (std::size_t j = 0; j < n; ++j) out.y[j] += change[j];
    if (length(change) <= 1e-16 * length(out.y)) break;
  }
  out.residual_norm = length(stacked.residual(out.y));
  for (std::size_t j = 0; j < n; ++j) out.y[j] *= stacked.scale[j];
  if (condition == Condition::compute) {
    const auto map = [n](const std::vector<double>& v) { return Eigen::Map<const Eigen::VectorXd>(v.data(), at(n)); };
    const std::vector<double> variances = SparseCovariance(stacked).variances();
    bound_rounding({map(variances).cwiseSqrt().cwiseProduct(map(stacked.scale)), map(stacked.column_norm), length(stacked.right)},
                   Reduction::orthogonal, accumulator.rows_pushed(), out);
  }
  return out;
}

}  // namespace jointid::minimise
