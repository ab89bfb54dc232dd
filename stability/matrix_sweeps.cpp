#include "stability/matrix_sweeps.hpp"

#include <chrono>
#include <cmath>
#include <limits>
#include <random>

#include "base/eigen.hpp"
#include "dense/svd.hpp"
#include "minimise/linear/linear_solution.hpp"
#include "minimise/linear/solve_linear.hpp"
#include "stability/exact_number.hpp"
#include "stability/svd_solution.hpp"

namespace jointid::stability {
namespace {

using Clock = std::chrono::steady_clock;

/// Adds the row (e, Σe): its solution is y = 1 up to the rounding of the sum.
void add_row(Rows& rows, const std::vector<double>& e, double right) {
  rows.high.insert(rows.high.end(), e.begin(), e.end());
  rows.high.push_back(right);
}

double sum(const std::vector<double>& e) {
  long double total = 0.0L;
  for (const double each : e) total += each;
  return static_cast<double>(total);
}

struct ExactSolution {
  std::vector<double> y, column_norms;
  double condition = 0.0;
};

ExactSolution solve_exactly(const Rows& rows) {
  const auto m = at(rows.count()), n = at(rows.unknowns);
  Real<Exact> e(m, n + 1);
  for (Eigen::Index i = 0; i < m; ++i) {
    for (Eigen::Index j = 0; j <= n; ++j) e(i, j) = Exact(rows.high[static_cast<std::size_t>(i * (n + 1) + j)]);
  }
  const Real<Exact> left = e.leftCols(n), r = exact_triangle(e);
  const Real<Exact> y = r.topLeftCorner(n, n).triangularView<Eigen::Upper>().solve(r.topRightCorner(n, 1));
  ExactSolution out;
  Eigen::MatrixXd unit(m, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Exact norm = left.col(j).norm();
    unit.col(j) = Real<Exact>(left.col(j) / norm).cast<double>();
    out.y.push_back(static_cast<double>(y(j, 0)));
    out.column_norms.push_back(static_cast<double>(norm));
  }
  const Eigen::VectorXd sigma = dense::jacobi_svd(unit, dense::Vectors::none, dense::Vectors::none).sigma;
  out.condition = sigma[n - 1] > 0.0 ? sigma[0] / sigma[n - 1] : std::numeric_limits<double>::infinity();
  return out;
}

minimise::LinearSolution solved(const Rows& rows, Way way, Measured& out) {
  minimise::LinearSolution linear;
  if (way == Way(OwnWay::qr_refined)) {
    const Refined refined = solve_refined(rows);
    linear.y = refined.y;
    linear.rank = refined.converged ? rows.unknowns : 0;
    return linear;
  }
  const bool is_normal = way == Way(ident::Solver::normal);
  minimise::Accumulator accumulator(rows.unknowns, is_normal ? minimise::Reduction::normal : minimise::Reduction::orthogonal);
  minimise::Accumulator::Columns columns;
  for (std::size_t j = 0; j < rows.unknowns; ++j) columns.push_back(j);
  for (std::size_t i = 0; i < rows.count(); ++i) {
    std::copy_n(rows.high.data() + i * (rows.unknowns + 1), rows.unknowns + 1, accumulator.triangle(columns).append(1));
  }
  linear = is_normal                         ? minimise::solve_normal(accumulator)
           : way == Way(ident::Solver::spqr) ? minimise::solve_sparse(accumulator)
           : way == Way(OwnWay::svd)         ? solve_svd(accumulator)
                                             : minimise::solve_dense(accumulator);
  out.bytes = accumulator.bytes();
  return linear;
}

}  // namespace

Rows hilbert(std::size_t size) {
  Rows rows{size, {}, {}};
  for (std::size_t i = 0; i < size; ++i) {
    std::vector<double> e;
    for (std::size_t j = 0; j < size; ++j) e.push_back(1.0 / static_cast<double>(i + j + 1));
    add_row(rows, e, sum(e));
  }
  return rows;
}

Rows laeuchli(std::size_t unknowns, double delta) {
  Rows rows{unknowns, {}, {}};
  std::vector<double> e(unknowns, 1.0), y;
  for (std::size_t j = 0; j < unknowns; ++j) y.push_back(std::sqrt(static_cast<double>(j + 1)));
  add_row(rows, e, sum(y));
  for (std::size_t j = 0; j < unknowns; ++j) {
    e.assign(unknowns, 0.0);
    e[j] = delta;
    add_row(rows, e, delta * y[j]);
  }
  return rows;
}

Rows weighted(std::size_t count, std::size_t unknowns, double spread) {
  Rows rows{unknowns, {}, {}};
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform;
  for (std::size_t i = 0; i < count; ++i) {
    const double weight = std::pow(spread, -uniform(random)), x = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    std::vector<double> e;
    for (std::size_t j = 0; j < unknowns; ++j) e.push_back(weight * std::pow(x, static_cast<double>(j)));
    add_row(rows, e, sum(e) * (1.0 + 1e-6 * (uniform(random) - 0.5)));
  }
  return rows;
}

Measured measure(const Rows& rows, Way way) {
  const ExactSolution exact = solve_exactly(rows);
  Measured out;
  out.method = "rows";
  out.solver = name(way);
  out.lines = rows.count();
  out.unknowns = rows.unknowns;
  out.condition = exact.condition;
  out.digits_true = std::numeric_limits<double>::quiet_NaN();
  const auto start = Clock::now();
  const minimise::LinearSolution linear = solved(rows, way, out);
  out.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  out.rank = linear.rank;
  if (linear.rank < rows.unknowns) out.status = ident::Status::rank_deficient;
  double difference = 0.0, size = 0.0, share = 0.0;
  bool beyond = false;
  for (std::size_t j = 0; j < rows.unknowns; ++j) {
    const double error = std::abs(linear.y[j] - exact.y[j]);
    difference = std::hypot(difference, exact.column_norms[j] * error);
    size = std::hypot(size, exact.column_norms[j] * exact.y[j]);
    if (linear.rounding.empty()) continue;
    beyond = beyond || !(error <= 10.0 * linear.rounding[j]);
    share = std::max(share, linear.rounding[j] / std::abs(linear.y[j]));
  }
  out.digits_kept = digits(difference / size);
  if (!linear.rounding.empty()) {
    out.digits_stated = digits(share);
    if (!(share <= 1.0)) out.status = ident::Status::imprecise;
    out.warned = share > 1e-2;
  }
  const bool told = out.status != ident::Status::ok || out.warned;
  if (std::holds_alternative<OwnWay>(way)) return out;
  out.verdict = told ? (difference < 1e-6 * size ? Honesty::false_alarm : Honesty::told) : beyond ? Honesty::silent_wrong : Honesty::right;
  return out;
}

}  // namespace jointid::stability
