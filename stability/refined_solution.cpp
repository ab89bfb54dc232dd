#include "stability/refined_solution.hpp"

#include <cmath>
#include <limits>

#include "base/eigen.hpp"
#include "minimise/linear/column_scaling.hpp"
#include "minimise/linear/linear_solution.hpp"
#include "minimise/linear/triangle.hpp"
#include "stability/exact_number.hpp"

namespace jointid::stability {
namespace {

using ExactColumn = Real<Exact>;

/// The problem with its columns and its rows' right-hand side in 50 digits, columns scaled by powers of two.
struct Problem {
  Real<Exact> e;
  ExactColumn p;
  Eigen::VectorXd scale;

  explicit Problem(const Rows& rows) {
    const auto m = at(rows.count()), n = at(rows.unknowns);
    e.resize(m, n);
    p.resize(m, 1);
    for (Eigen::Index i = 0; i < m; ++i) {
      for (Eigen::Index j = 0; j <= n; ++j) {
        const auto at = static_cast<std::size_t>(i * (n + 1) + j);
        const Exact value = rows.low.empty() ? Exact(rows.high[at]) : Exact(Exact(rows.high[at]) + Exact(rows.low[at]));
        (j < n ? e(i, j) : p(i, 0)) = value;
      }
    }
    scale = minimise::power_of_two_scales(e.cast<double>());
    e = e * scale.cast<Exact>().asDiagonal();
  }
};

/// R and Qᵀf of [E | f] in double precision.
struct Factored {
  Eigen::MatrixXd r;
  Eigen::VectorXd qf;

  Factored(const Eigen::MatrixXd& e, const Eigen::VectorXd& f) {
    const auto n = static_cast<std::size_t>(e.cols());
    minimise::Triangle triangle(n);
    for (Eigen::Index i = 0; i < e.rows(); ++i) {
      double* row = triangle.append(1);
      for (Eigen::Index j = 0; j < e.cols(); ++j) row[j] = e(i, j);
      row[n] = f[i];
    }
    triangle.flush();
    r = Eigen::MatrixXd::Zero(e.cols(), e.cols());
    qf.resize(e.cols());
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i; j < n; ++j) r(at(i), at(j)) = triangle(i, j);
      qf[at(i)] = triangle(i, n);
    }
  }
};

}  // namespace

Refined solve_refined(const Rows& rows, std::size_t most_steps) {
  const Problem problem(rows);
  const Eigen::MatrixXd e = problem.e.cast<double>();
  ExactColumn y = ExactColumn::Zero(e.cols(), 1), r = ExactColumn::Zero(e.rows(), 1);
  Refined out;
  while (out.steps < most_steps && !out.converged) {
    ++out.steps;
    // f = p − r − Ey, g = −Eᵀr; δr + Eδy = f, Eᵀδr = g.
    const ExactColumn f = problem.p - r - problem.e * y, g = -(problem.e.transpose() * r);
    const Factored factored(e, f.cast<double>());
    const auto upper = factored.r.triangularView<Eigen::Upper>();
    const Eigen::VectorXd lower = upper.transpose().solve(Eigen::VectorXd(g.cast<double>()));
    const Eigen::VectorXd step = upper.solve(factored.qf - lower);
    y += step.cast<Exact>();
    // The part of f in the range of E belongs to the unknowns: δr = f − Eδy.
    r += f - problem.e * step.cast<Exact>();
    const Eigen::VectorXd reached = y.cast<double>();
    constexpr double eps = std::numeric_limits<double>::epsilon();
    out.converged = out.steps > 1 && (step.array().abs() <= 4.0 * eps * reached.array().abs()).all();
  }
  const Eigen::VectorXd unscaled = problem.scale.asDiagonal() * y.cast<double>();
  out.y.assign(unscaled.begin(), unscaled.end());
  out.residual_norm = static_cast<double>(Exact(ExactColumn(problem.p - problem.e * y).norm()));
  return out;
}

}  // namespace jointid::stability
