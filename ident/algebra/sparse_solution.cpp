#include <SuiteSparseQR.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/eigen.hpp"
#include "ident/algebra/column_scaling.hpp"
#include "ident/algebra/linear_solution.hpp"
#include "ident/algebra/null_space.hpp"
#include "ident/algebra/rounding.hpp"
#include "ident/algebra/solve_linear.hpp"

namespace jointid::ident {
namespace {

/// CHOLMOD's workspace for one solve.
class Common {
 public:
  Common() { cholmod_l_start(&common_); }
  ~Common() { cholmod_l_finish(&common_); }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;
  cholmod_common* get() { return &common_; }

 private:
  cholmod_common common_;
};

/// The stacked triangles as scaled triplets, and their right-hand side.
struct StackedTriangles {
  std::size_t rows = 0, entries = 0;
  std::vector<double> scale, column_norm;

  explicit StackedTriangles(const Accumulator& accumulator) {
    std::vector<double> norm2(accumulator.columns(), 0.0);
    for (const auto& [columns, triangle] : accumulator.triangles()) {
      rows += columns.size() + 1;
      entries += columns.size() * (columns.size() + 1) / 2;
      for (std::size_t j = 0; j < columns.size(); ++j) {
        for (std::size_t i = 0; i <= j; ++i) norm2[columns[j]] += triangle(i, j) * triangle(i, j);
      }
    }
    for (const double square : norm2) {
      scale.push_back(power_of_two_scale(std::sqrt(square)));
      column_norm.push_back(std::sqrt(square));
    }
  }
};

void fill(const Accumulator& accumulator, const std::vector<double>& scale, cholmod_triplet* triplet,
          double* right_side) {
  auto* row_index = static_cast<SuiteSparse_long*>(triplet->i);
  auto* column_index = static_cast<SuiteSparse_long*>(triplet->j);
  auto* value = static_cast<double*>(triplet->x);
  std::size_t row = 0, entry = 0;
  for (const auto& [columns, triangle] : accumulator.triangles()) {
    const std::size_t n = columns.size();
    for (std::size_t i = 0; i <= n; ++i, ++row) {
      for (std::size_t j = i; j < n; ++j, ++entry) {
        row_index[entry] = static_cast<SuiteSparse_long>(row);
        column_index[entry] = static_cast<SuiteSparse_long>(columns[j]);
        value[entry] = triangle(i, j) * scale[columns[j]];
      }
      right_side[row] = triangle(i, n);
    }
  }
  triplet->nnz = entry;
}

/// The factor R of A(:,permutation) = QR as SPQR leaves it: upper trapezoidal, where a column that depends on those before
/// it has no pivot of its own.
class Staircase {
 public:
  Staircase(const cholmod_sparse& r, const SuiteSparse_long* permutation, std::size_t rank)
      : start_(static_cast<const SuiteSparse_long*>(r.p)),
        row_(static_cast<const SuiteSparse_long*>(r.i)),
        value_(static_cast<const double*>(r.x)) {
    for (std::size_t k = 0; k < r.ncol; ++k) {
      column_.push_back(permutation == nullptr ? k : static_cast<std::size_t>(permutation[k]));
      double pivot = 0.0;
      for_each(k, [&](std::size_t row, double value) { pivot = row == owner_.size() ? value : pivot; });
      if (pivot != 0.0 && owner_.size() < rank) {
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
    for (SuiteSparse_long e = start_[k]; e < start_[k + 1]; ++e) visit(static_cast<std::size_t>(row_[e]), value_[e]);
  }

  const SuiteSparse_long* start_;
  const SuiteSparse_long* row_;
  const double* value_;
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
  Common common;
  cholmod_common* cc = common.get();
  cholmod_triplet* triplet = cholmod_l_allocate_triplet(stacked.rows, n, stacked.entries, 0, CHOLMOD_REAL, cc);
  cholmod_dense* right = cholmod_l_zeros(stacked.rows, 1, CHOLMOD_REAL, cc);
  fill(accumulator, stacked.scale, triplet, static_cast<double*>(right->x));
  cholmod_sparse* matrix = cholmod_l_triplet_to_sparse(triplet, triplet->nnz, cc);
  cholmod_l_free_triplet(&triplet, cc);

  // Columns have about unit length after scaling, so an absolute pivot threshold is a relative one.
  const double tolerance = 16.0 * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
  cholmod_sparse* r = nullptr;
  cholmod_dense* q_right = nullptr;
  SuiteSparse_long* permutation = nullptr;
  const SuiteSparse_long rank =
      SuiteSparseQR<double>(SPQR_ORDERING_DEFAULT, tolerance, static_cast<SuiteSparse_long>(n), matrix, right, &q_right,
                            &r, &permutation, cc);
  LinearSolution out;
  const Staircase staircase(*r, permutation, static_cast<std::size_t>(std::max<SuiteSparse_long>(rank, 0)));
  out.rank = staircase.pivots().size();
  const double* c = static_cast<const double*>(q_right->x);
  out.y = staircase.solve({c, c + q_right->nrow});
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
  const double right_norm = cholmod_l_norm_dense(right, 2, cc);
  cholmod_dense* solution = cholmod_l_zeros(n, 1, CHOLMOD_REAL, cc);
  std::copy(out.y.begin(), out.y.end(), static_cast<double*>(solution->x));
  double one[2] = {1.0, 0.0}, minus_one[2] = {-1.0, 0.0};
  cholmod_l_sdmult(matrix, 0, one, minus_one, solution, right, cc);
  out.residual_norm = cholmod_l_norm_dense(right, 2, cc);
  for (std::size_t j = 0; j < n; ++j) out.y[j] *= stacked.scale[j];
  if (asked == Condition::compute && out.rank == n) {
    const auto map = [n](const std::vector<double>& v) {
      return Eigen::Map<const Eigen::VectorXd>(v.data(), at(n));
    };
    bound_rounding({inverse_rows(staircase, n).cwiseProduct(map(stacked.scale)), map(stacked.column_norm), right_norm},
                   Reduction::orthogonal, accumulator.rows_pushed(), out);
  }

  cholmod_l_free_dense(&solution, cc);
  cholmod_l_free_dense(&q_right, cc);
  cholmod_l_free_dense(&right, cc);
  cholmod_l_free_sparse(&r, cc);
  cholmod_l_free_sparse(&matrix, cc);
  if (permutation != nullptr) cholmod_l_free(n, sizeof(SuiteSparse_long), permutation, cc);
  return out;
}

}  // namespace jointid::ident
