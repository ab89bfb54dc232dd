#include "coupling/propagation.hpp"

#include <cmath>

#include "base/eigen.hpp"
#include "coupling/joint_loop.hpp"
#include "coupling/jumps.hpp"
#include "dense/cholesky.hpp"

namespace jointid::coupling {
namespace {

/// Adds `values` (one per condition) times a row of B to a vector over coordinates.
template <class Vector, class Values>
void add_conditions(Vector&& to, const Values& values, const Conditions& conditions) {
  for (std::size_t p = 0; p < conditions.size(); ++p) {
    const Complex value = values[at(p)];
    to[conditions[p].first] += value;
    if (conditions[p].second) to[*conditions[p].second] -= conditions[p].sign * value;
  }
}

/// |L|² V |R|² or L² V R² by blocks; what stands behind the first b rows and columns of V is only used where it belongs.
template <class Left, class Right, class Values>
auto sandwich(const Left& left, const Values& v, const Right& right, const Wanted& wanted) {
  const Index b = left.cols();
  using Matrix = Eigen::Matrix<typename Left::Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  Matrix rows = left * v.topRows(b).template cast<typename Left::Scalar>();
  for (Index r = 0; r < rows.rows(); ++r) {
    const Index own = wanted.rows[static_cast<std::size_t>(r)];
    if (own >= b) rows.row(r) += v.row(own).template cast<typename Left::Scalar>();
  }
  Matrix out = rows.leftCols(b) * right;
  for (Index c = 0; c < out.cols(); ++c) {
    const Index own = wanted.columns[static_cast<std::size_t>(c)];
    if (own >= b) out.col(c) += rows.col(own);
  }
  return out;
}

bool is_shared(const MatrixRef& h, Index k, Index l, Index back_k, Index back_l) {
  return is_one_measurement(h(k, l), h(back_k, back_l)) && h(k, l) != Complex(0.0);
}

/// Variances among the first b coordinates that (k,l) and (l,k) share; the diagonal is 0.
RealMatrix shared(const RealMatrix& v, const MatrixRef& h, Index b) {
  RealMatrix out = RealMatrix::Zero(b, b);
  for (Index k = 0; k < b; ++k) {
    for (Index l = 0; l < b; ++l) {
      if (k != l && is_shared(h, k, l, l, k)) out(k, l) = v(k, l);
    }
  }
  return out;
}

/// What shared errors add to the sums of |a|²v and Re(a²)v: Σ_{k≠l} Re(a_kl a*_lk) v_kl and Σ_{k≠l} Re(a_kl a_lk) v_kl.
struct SharedErrors {
  const Sensitivity& at;
  const MatrixRef& h;
  const RealMatrix &plus, &minus;

  /// k and l among the first b coordinates: a_kl a*_lk = w_k w*_l with w_k = L_rk R*_kc.
  void add_inner(RealMatrix& sum, RealMatrix& difference) const {
    const Index b = at.left.cols();
    const RealMatrix p = shared(plus, h, b), m = shared(minus, h, b);
    if (p.isZero(0.0)) return;
    for (Index c = 0; c < at.right.cols(); ++c) {
      for (Index r = 0; r < at.left.rows(); ++r) {
        const Eigen::VectorXcd w = at.left.row(r).transpose().cwiseProduct(at.right.col(c).conjugate());
        const Eigen::VectorXcd u = at.left.row(r).transpose().cwiseProduct(at.right.col(c));
        sum(r, c) += w.dot(p.cast<Complex>() * w).real();
        difference(r, c) += (u.transpose() * m.cast<Complex>() * u).value().real();
      }
    }
  }

  /// One of them a coordinate behind b, which matters for its point FRF: a_(own,l) = R_lc, a_(l,own) = L_rl.
  void add_point(Index r, Index c, Index own, Index column, RealMatrix& sum, RealMatrix& difference) const {
    for (Index l = 0; l < at.left.cols(); ++l) {
      if (!is_shared(h, own, l, l, column)) continue;
      sum(r, c) += 2.0 * (at.right(l, c) * std::conj(at.left(r, l))).real() * plus(own, l);
      difference(r, c) += 2.0 * (at.right(l, c) * at.left(r, l)).real() * minus(own, l);
    }
  }
};

double or_zero(double value) { return std::isfinite(value) ? value : 0.0; }

/// L with the 1 of rows behind b.
ComplexMatrix whole_left(const Sensitivity& of, const Wanted& wanted, Index rows) {
  ComplexMatrix left = ComplexMatrix::Zero(of.left.rows(), rows);
  left.leftCols(of.left.cols()) = of.left;
  for (Index r = 0; r < left.rows(); ++r) {
    const Index own = wanted.rows[static_cast<std::size_t>(r)];
    if (own >= of.left.cols()) left(r, own) += 1.0;
  }
  return left;
}

/// R with the 1 of columns behind b.
ComplexMatrix whole_right(const Sensitivity& of, const Wanted& wanted, Index columns) {
  ComplexMatrix right = ComplexMatrix::Zero(columns, of.right.cols());
  right.topRows(of.right.rows()) = of.right;
  for (Index c = 0; c < right.cols(); ++c) {
    const Index own = wanted.columns[static_cast<std::size_t>(c)];
    if (own >= of.right.rows()) right(own, c) += 1.0;
  }
  return right;
}

/// What columns that share errors add to the covariances of the result.
void add_between_columns(const ComplexMatrix& left, const ComplexMatrix& right, const LineVariance& variance,
                         const SharedColumns& shared, std::vector<ComplexMatrix>& out) {
  const std::size_t count = shared.columns.size();
  std::vector<ComplexMatrix> moved;  // L K of each column
  for (const Index l : shared.columns) {
    const bool counts = !right.row(l).isZero(0.0);
    moved.push_back(counts ? ComplexMatrix(left(Eigen::all, shared.rows) * covariance_factor(variance, shared.rows, l))
                           : ComplexMatrix());
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const Complex correlation = shared.correlation(at(i), at(k));
      if (moved[i].size() == 0 || moved[k].size() == 0 || !(std::abs(correlation) > 0.0)) continue;
      const ComplexMatrix between = correlation * (moved[i] * moved[k].adjoint());
      for (Index c = 0; c < right.cols(); ++c) {
        const Complex by = right(shared.columns[i], c) * std::conj(right(shared.columns[k], c));
        if (by == Complex(0.0)) continue;
        const ComplexMatrix one_side = by * between;
        out[static_cast<std::size_t>(c)] += one_side + one_side.adjoint();
      }
    }
  }
}

/// Covariances of the result, and on their diagonals what those of H add to the variances of its entries. What is not known counts
/// for nothing: the variances say where that matters.
std::vector<ComplexMatrix> propagated_covariance(const Sensitivity& of, const LineVariance& variance, const RealMatrix& plus,
                                                 const Wanted& wanted) {
  const ComplexMatrix left = whole_left(of, wanted, plus.rows());
  const ComplexMatrix whole = whole_right(of, wanted, plus.cols());
  const RealMatrix right = whole.cwiseAbs2();
  std::vector<ComplexMatrix> out(wanted.columns.size(), ComplexMatrix::Zero(left.rows(), left.rows()));
  for (Index l = 0; l < plus.cols(); ++l) {
    if (right.row(l).isZero(0.0)) continue;
    ComplexMatrix c = variance.covariance[static_cast<std::size_t>(l)];
    c.diagonal().setZero();
    ComplexMatrix between = left * c * left.adjoint();
    const ComplexMatrix own = left * plus.col(l).unaryExpr(&or_zero).cast<Complex>().asDiagonal() * left.adjoint();
    for (Index r = 0; r < own.rows(); ++r) {
      for (Index s = 0; s < own.cols(); ++s) {
        if (r != s) between(r, s) += own(r, s);
      }
    }
    for (Index k = 0; k < right.cols(); ++k) {
      if (right(l, k) != 0.0) out[static_cast<std::size_t>(k)] += right(l, k) * between;
    }
  }
  for (const SharedColumns& shared : variance.shared) add_between_columns(left, whole, variance, shared, out);
  return out;
}

}  // namespace

ComplexMatrix covariance_factor(const LineVariance& variance, const std::vector<Index>& rows, Index l) {
  ComplexMatrix c = variance.covariance[static_cast<std::size_t>(l)](rows, rows);
  for (Index i = 0; i < c.rows(); ++i) {
    const Index row = rows[static_cast<std::size_t>(i)];
    c(i, i) = or_zero(variance.real(row, l) + variance.imaginary(row, l));
    if (c(i, i) != Complex(0.0)) continue;
    c.row(i).setZero();
    c.col(i).setZero();
  }
  return dense::semidefinite_cholesky(c);
}

Sensitivity sensitivity(const MatrixRef& h, const Conditions& conditions, const MatrixRef& s_inverse, const Wanted& wanted,
                        Index coordinates) {
  Sensitivity out{ComplexMatrix::Zero(at(wanted.rows.size()), coordinates),
                  ComplexMatrix::Zero(coordinates, at(wanted.columns.size()))};
  const ComplexMatrix whole = h;
  const ComplexMatrix left = -column_jumps(whole, conditions, wanted.rows) * s_inverse;
  const ComplexMatrix right = -s_inverse * row_jumps(whole, conditions, wanted.columns);
  for (Index r = 0; r < out.left.rows(); ++r) {
    add_conditions(out.left.row(r), left.row(r), conditions);
    const Index own = wanted.rows[static_cast<std::size_t>(r)];
    if (own < coordinates) out.left(r, own) += 1.0;
  }
  for (Index c = 0; c < out.right.cols(); ++c) {
    add_conditions(out.right.col(c), right.col(c), conditions);
    const Index own = wanted.columns[static_cast<std::size_t>(c)];
    if (own < coordinates) out.right(own, c) += 1.0;
  }
  return out;
}

Sensitivity before(const Sensitivity& conditions, const MatrixRef& h, const std::vector<Index>& at, const MatrixRef& z,
                   const Wanted& wanted) {
  const Index b = conditions.left.cols();
  const ComplexMatrix m = force_with_joint(z, ComplexMatrix(h(at, at)), z);
  // Rows of L₁ and columns of R₁ that differ from those of the identity.
  const ComplexMatrix left = ComplexMatrix(h(Eigen::all, at)) * m, right = m * ComplexMatrix(h(at, Eigen::all));
  Sensitivity out = conditions;
  out.left(Eigen::all, at) -= conditions.left * left.topRows(b);
  out.right(at, Eigen::all) -= right.leftCols(b) * conditions.right;
  for (Index r = 0; r < out.left.rows(); ++r) {
    const Index own = wanted.rows[static_cast<std::size_t>(r)];
    if (own >= b) out.left(r, at) -= left.row(own);
  }
  for (Index c = 0; c < out.right.cols(); ++c) {
    const Index own = wanted.columns[static_cast<std::size_t>(c)];
    if (own >= b) out.right(at, c) -= right.col(own);
  }
  return out;
}

LineVariance propagate(const Sensitivity& at, const MatrixRef& h, const LineVariance& variance, const Wanted& wanted,
                       const std::vector<Index>& twin) {
  // Re(aδ) has the variance ½|a|²(v_re + v_im) + ½ Re(a²)(v_re − v_im), Im(aδ) the same with a minus; a_kl = L_rk R_lc.
  const RealMatrix plus = variance.real + variance.imaginary, minus = variance.real - variance.imaginary;
  RealMatrix sum = sandwich(RealMatrix(at.left.cwiseAbs2()), plus, RealMatrix(at.right.cwiseAbs2()), wanted);
  RealMatrix difference =
      sandwich(ComplexMatrix(at.left.cwiseProduct(at.left)), minus, ComplexMatrix(at.right.cwiseProduct(at.right)), wanted).real();
  const SharedErrors errors{at, h, plus, minus};
  errors.add_inner(sum, difference);
  const Index b = at.left.cols();
  for (Index r = 0; r < sum.rows(); ++r) {
    const Index own = wanted.rows[static_cast<std::size_t>(r)];
    if (own < b || twin[static_cast<std::size_t>(own - b)] < 0) continue;
    for (Index c = 0; c < sum.cols(); ++c) {
      const Index column = wanted.columns[static_cast<std::size_t>(c)];
      if (column == twin[static_cast<std::size_t>(own - b)]) errors.add_point(r, c, own, column, sum, difference);
    }
  }
  if (variance.covariance.empty()) return {0.5 * (sum + difference), 0.5 * (sum - difference)};
  std::vector<ComplexMatrix> covariance = propagated_covariance(at, variance, plus, wanted);
  for (Index c = 0; c < sum.cols(); ++c) sum.col(c) += covariance[static_cast<std::size_t>(c)].diagonal().real();
  return {0.5 * (sum + difference), 0.5 * (sum - difference), std::move(covariance)};
}

}  // namespace jointid::coupling
