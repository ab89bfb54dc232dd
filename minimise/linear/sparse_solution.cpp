#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/eigen.hpp"
#include "minimise/linear/column_scaling.hpp"
#include "minimise/linear/linear_solution.hpp"
#include "minimise/linear/null_space.hpp"
#include "minimise/linear/rounding.hpp"
#include "minimise/linear/solve_linear.hpp"
#include "minimise/linear/sparse_qr.hpp"

namespace jointid::minimise {
namespace {

/// The stacked triangles with scaled columns, their right-hand side b, and what their columns were scaled by.
struct StackedTriangles {
  SparseEntries matrix;
  std::vector<double> right, scale, column_norm;

  explicit StackedTriangles(const Accumulator& accumulator) {
    matrix.columns = accumulator.columns();
    std::vector<double> norm2(matrix.columns, 0.0);
    std::size_t entries = 0;
    for (const auto& [columns, triangle] : accumulator.triangles()) {
      entries += columns.size() * (columns.size() + 1) / 2;
      for (std::size_t j = 0; j < columns.size(); ++j) {
        for (std::size_t i = 0; i <= j; ++i) norm2[columns[j]] += triangle(i, j) * triangle(i, j);
      }
    }
    for (const double square : norm2) {
      scale.push_back(power_of_two_scale(std::sqrt(square)));
      column_norm.push_back(std::sqrt(square));
    }
    matrix.row.reserve(entries);
    matrix.column.reserve(entries);
    matrix.value.reserve(entries);
    for (const auto& [columns, triangle] : accumulator.triangles()) append(columns, triangle);
  }

 private:
  void append(const std::vector<std::size_t>& columns, const Triangle& triangle) {
    const std::size_t n = columns.size();
    for (std::size_t i = 0; i <= n; ++i, ++matrix.rows) {
      for (std::size_t j = i; j < n; ++j) {
        matrix.row.push_back(static_cast<std::int64_t>(matrix.rows));
        matrix.column.push_back(static_cast<std::int64_t>(columns[j]));
        matrix.value.push_back(triangle(i, j) * scale[columns[j]]);
      }
      right.push_back(triangle(i, n));
    }
  }
};

double norm(const std::vector<double>& v) { return Eigen::Map<const Eigen::VectorXd>(v.data(), at(v.size())).norm(); }

/// b − A y.
std::vector<double> residual(const StackedTriangles& stacked, const std::vector<double>& y) {
  std::vector<double> out = stacked.right;
  const SparseEntries& a = stacked.matrix;
  for (std::size_t e = 0; e < a.value.size(); ++e) {
    out[static_cast<std::size_t>(a.row[e])] -= a.value[e] * y[static_cast<std::size_t>(a.column[e])];
  }
  return out;
}

/// The factor R of A(:,permutation) = QR as SPQR leaves it: upper trapezoidal, where a column that depends on those before
/// it has no pivot of its own.
class Staircase {
 public:
  explicit Staircase(const SparseQr& r) : r_(r) {
    for (std::size_t k = 0; k + 1 < r.start.size(); ++k) {
      column_.push_back(r.permutation.empty() ? k : static_cast<std::size_t>(r.permutation[k]));
      double pivot = 0.0;
      for_each(k, [&](std::size_t row, double value) { pivot = row == owner_.size() ? value : pivot; });
      if (pivot != 0.0 && owner_.size() < r.rank) {
        owner_.push_back(k);
        pivot_.push_back(pivot);
      } else {
        dependent_.push_back(k);
      }
    }
  }

  const std::vector<double>& pivots() const { return pivot_; }

  /// Basic solution of R x = c: columns without a pivot are zero.
  std::vector<double> solve(std::vector<double> c) const {
    std::vector<double> x(column_.size(), 0.0);
    for (std::size_t row = owner_.size(); row-- > 0;) {
      const double unknown = c[row] / pivot_[row];
      x[column_[owner_[row]]] = unknown;
      for_each(owner_[row], [&](std::size_t above, double value) { c[above] -= value * unknown; });
    }
    return x;
  }

  /// Basis of the null space: a column without a pivot, and what undoes it, at a time.
  Eigen::MatrixXd null_space() const {
    const auto index = [](std::size_t i) { return at(i); };
    Eigen::MatrixXd basis(index(column_.size()), index(dependent_.size()));
    for (std::size_t d = 0; d < dependent_.size(); ++d) {
      std::vector<double> c(owner_.size(), 0.0);
      for_each(dependent_[d], [&](std::size_t row, double value) {
        if (row < c.size()) c[row] = -value;
      });
      const std::vector<double> x = solve(c);
      basis.col(index(d)) = Eigen::Map<const Eigen::VectorXd>(x.data(), index(x.size()));
      basis(index(column_[dependent_[d]]), index(d)) = 1.0;
    }
    return basis;
  }

 private:
  template <class Visit>
  void for_each(std::size_t k, const Visit& visit) const {
    for (auto e = static_cast<std::size_t>(r_.start[k]); e < static_cast<std::size_t>(r_.start[k + 1]); ++e) {
      visit(static_cast<std::size_t>(r_.row[e]), r_.value[e]);
    }
  }

  const SparseQr& r_;
  std::vector<std::size_t> column_;     ///< permuted → original
  std::vector<std::size_t> owner_;      ///< row → permuted column with its pivot
  std::vector<std::size_t> dependent_;  ///< permuted columns without one
  std::vector<double> pivot_;
};

/// ‖rows of R⁻¹‖: with normal numbers of variance 1 on the right, those are the standard deviations of the unknowns.
Eigen::VectorXd inverse_rows(const Staircase& staircase, std::size_t n) {
  constexpr int samples = 16;
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(at(n));
  for (int i = 0; i < samples; ++i) {
    std::vector<double> right(n);
    for (double& each : right) each = normal(random);
    const std::vector<double> x = staircase.solve(std::move(right));
    squares += Eigen::Map<const Eigen::VectorXd>(x.data(), squares.size()).cwiseAbs2();
  }
  return (squares / samples).cwiseSqrt();
}

}  // namespace

LinearSolution solve_sparse(Accumulator& accumulator, Condition asked) {
  accumulator.flush();
  const std::size_t n = accumulator.columns();
  const StackedTriangles stacked(accumulator);
  // Columns have about unit length after scaling, so an absolute pivot threshold is a relative one.
  const double tolerance = 16.0 * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
  const SparseQr factors = sparse_qr(stacked.matrix, stacked.right, tolerance);
  LinearSolution out;
  const Staircase staircase(factors);
  out.rank = staircase.pivots().size();
  out.y = staircase.solve(factors.rotated);
  if (out.rank < n) {
    const Eigen::MatrixXd basis = staircase.null_space();
    tell_null_space(basis, out);
    Eigen::Map<Eigen::VectorXd> y(out.y.data(), at(n));
    y = minimum_norm(basis, y);
  }

  // Pivots bound the condition number from below; an SVD of a large sparse matrix costs more than the solution.
  const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const auto [least, most] = std::minmax_element(staircase.pivots().begin(), staircase.pivots().end(), smaller);
  out.condition = out.rank < n ? std::numeric_limits<double>::infinity() : std::abs(*most / *least);
  out.residual_norm = norm(residual(stacked, out.y));
  for (std::size_t j = 0; j < n; ++j) out.y[j] *= stacked.scale[j];
  if (asked == Condition::compute && out.rank == n) {
    const auto map = [n](const std::vector<double>& v) { return Eigen::Map<const Eigen::VectorXd>(v.data(), at(n)); };
    bound_rounding({inverse_rows(staircase, n).cwiseProduct(map(stacked.scale)), map(stacked.column_norm), norm(stacked.right)},
                   Reduction::orthogonal, accumulator.rows_pushed(), out);
  }
  return out;
}

}  // namespace jointid::minimise
