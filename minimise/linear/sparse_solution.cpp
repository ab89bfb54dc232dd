#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/eigen.hpp"
#include "dense/qr.hpp"
#include "dense/svd.hpp"
#include "minimise/linear/linear_solution.hpp"
#include "minimise/linear/null_space.hpp"
#include "minimise/linear/rounding.hpp"
#include "minimise/linear/solve_linear.hpp"
#include "minimise/linear/sparse_covariance.hpp"
#include "minimise/linear/sparse_normal.hpp"
#include "minimise/linear/sparse_qr.hpp"
#include "minimise/linear/stacked_triangles.hpp"

namespace jointid::minimise {
namespace {

double norm(const std::vector<double>& v) { return Eigen::Map<const Eigen::VectorXd>(v.data(), at(v.size())).norm(); }

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

  /// x of RᵀR x = c where no column depends on others.
  std::vector<double> solve_normal(const std::vector<double>& c) const {
    std::vector<double> z(owner_.size());
    for (std::size_t row = 0; row < owner_.size(); ++row) {
      double sum = c[column_[owner_[row]]];
      for_each(owner_[row], [&](std::size_t above, double value) {
        if (above < row) sum -= value * z[above];
      });
      z[row] = sum / pivot_[row];
    }
    return solve(std::move(z));
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

/// Smallest singular values of A with their directions, by inverse iteration with R: SPQR's own rank says full of matrices whose smallest
/// singular value is 1e-15 (Kahan). Directions below `least` are a basis of the null space.
struct SmallestValues {
  double smallest = 0.0;
  Eigen::MatrixXd null_space;
};

Eigen::MatrixXd times(const StackedTriangles& stacked, const Eigen::MatrixXd& v) {
  Eigen::MatrixXd out(at(stacked.matrix.rows), v.cols());
  for (Eigen::Index c = 0; c < v.cols(); ++c) {
    const std::vector<double> image = stacked.product({v.col(c).begin(), v.col(c).end()});
    out.col(c) = Eigen::Map<const Eigen::VectorXd>(image.data(), out.rows());
  }
  return out;
}

Eigen::MatrixXd random_block(Eigen::Index rows, Eigen::Index columns) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return normal(random); });
}

SmallestValues smallest_values(const StackedTriangles& stacked, const Staircase& staircase, double least) {
  const Eigen::Index n = at(stacked.matrix.columns);
  for (Eigen::Index width = std::min<Eigen::Index>(4, n);; width = std::min(2 * width, n)) {
    Eigen::MatrixXd v = dense::orthonormal_columns(random_block(n, width));
    for (int step = 0; step < 4; ++step) {
      for (Eigen::Index c = 0; c < width; ++c) {
        const std::vector<double> x = staircase.solve_normal({v.col(c).begin(), v.col(c).end()});
        v.col(c) = Eigen::Map<const Eigen::VectorXd>(x.data(), n).stableNormalized();
      }
      if (!v.allFinite()) return {};
      v = dense::orthonormal_columns(v);
    }
    const Eigen::MatrixXd image = times(stacked, v);
    const dense::RealSvd svd = dense::svd(image, dense::Vectors::none, dense::Vectors::full);
    const Eigen::Index count = v.cols(), below = (svd.sigma.array() <= least).count();
    if (below < count || width == n || width >= 64) return {svd.sigma[count - 1], v * svd.v.rightCols(below)};
  }
}

/// Largest singular value, from below.
double largest_value(const StackedTriangles& stacked) {
  Eigen::VectorXd x = random_block(at(stacked.matrix.columns), 1).normalized();
  double largest = 0.0;
  for (int step = 0; step < 10 && x.size() > 0; ++step) {
    const std::vector<double> image = stacked.product({x.begin(), x.end()});
    largest = norm(image);
    const std::vector<double> back = stacked.transposed(image);
    x = Eigen::Map<const Eigen::VectorXd>(back.data(), x.size()).stableNormalized();
  }
  return largest;
}

LinearSolution solve_by_qr(Accumulator& accumulator, Condition asked) {
  const std::size_t n = accumulator.columns();
  const StackedTriangles stacked(accumulator);
  // Columns have about unit length after scaling, so an absolute pivot threshold is a relative one.
  const double tolerance = 16.0 * static_cast<double>(n) * std::numeric_limits<double>::epsilon();
  const SparseQr factors = sparse_qr(stacked.matrix, stacked.right, tolerance);
  LinearSolution out;
  const Staircase staircase(factors);
  out.rank = staircase.pivots().size();
  out.y = staircase.solve(factors.rotated);
  Eigen::MatrixXd basis;
  double smallest = 0.0;
  const double largest = largest_value(stacked);
  if (out.rank < n) {
    basis = staircase.null_space();
  } else {
    SmallestValues found = smallest_values(stacked, staircase, static_cast<double>(n) * std::numeric_limits<double>::epsilon() * largest);
    basis = std::move(found.null_space);
    smallest = found.smallest;
    out.rank -= static_cast<std::size_t>(basis.cols());
  }
  if (out.rank < n) {
    tell_null_space(basis, out);
    Eigen::Map<Eigen::VectorXd> y(out.y.data(), at(n));
    y = minimum_norm(basis, y);
  }
  out.condition = out.rank < n ? std::numeric_limits<double>::infinity() : largest / smallest;
  out.residual_norm = norm(stacked.residual(out.y));
  for (std::size_t j = 0; j < n; ++j) out.y[j] *= stacked.scale[j];
  if (asked == Condition::compute && out.rank == n) {
    const auto map = [n](const std::vector<double>& v) { return Eigen::Map<const Eigen::VectorXd>(v.data(), at(n)); };
    constexpr double exact = 1e6;  // up to this condition number the normal matrix tells the norms
    const std::vector<double> variances = out.condition < exact ? SparseCovariance(stacked).variances() : std::vector<double>();
    const Eigen::VectorXd rows = variances.empty() ? inverse_rows(staircase, n) : Eigen::VectorXd(map(variances).cwiseSqrt());
    bound_rounding({rows.cwiseProduct(map(stacked.scale)), map(stacked.column_norm), norm(stacked.right)}, Reduction::orthogonal,
                   accumulator.rows_pushed(), out);
  }
  return out;
}

}  // namespace

LinearSolution solve_sparse(Accumulator& accumulator, Condition asked, SparseWay way) {
  accumulator.flush();
  if (way == SparseWay::qr) return solve_by_qr(accumulator, asked);
  if (std::optional<LinearSolution> out = solve_sparse_normal(accumulator, asked, way)) return *out;
  return has_spqr() ? solve_by_qr(accumulator, asked) : solve_dense(accumulator, asked);
}

}  // namespace jointid::minimise
