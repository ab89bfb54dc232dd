#pragma once

#include "counted.hpp"
#include "coupling/jumps.hpp"
#include "coupling/mtc_steps.hpp"

namespace jointid::coupling {

using CountedMatrix = Eigen::Matrix<Counted, Eigen::Dynamic, Eigen::Dynamic>;

/// The inverse by Gauss–Jordan elimination of [A | I] as in appendix D of the thesis.
inline CountedMatrix gauss_jordan_inverse(CountedMatrix a) {
  const Index m = a.rows();
  CountedMatrix inverse = CountedMatrix::Constant(m, m, Counted(0.0));
  for (Index i = 0; i < m; ++i) inverse(i, i) = Counted(1.0);
  for (Index k = 0; k < m; ++k) {
    const Counted pivot = Counted(1.0) / a(k, k);
    for (Index j = k + 1; j < m; ++j) a(k, j) *= pivot;
    for (Index j = 0; j <= k; ++j) {
      if (j == k) {
        inverse(k, j) = pivot;
      } else {
        inverse(k, j) *= pivot;
      }
    }
    for (Index i = 0; i < m; ++i) {
      if (i == k) continue;
      for (Index j = k + 1; j < m; ++j) a(i, j) -= a(i, k) * a(k, j);
      for (Index j = 0; j <= k; ++j) inverse(i, j) -= a(i, k) * inverse(k, j);
    }
  }
  return inverse;
}

/// A·B without the multiplications by 1 that Eigen's products add.
inline CountedMatrix product(const CountedMatrix& a, const CountedMatrix& b) {
  CountedMatrix out = CountedMatrix::Constant(a.rows(), b.cols(), Counted(0.0));
  for (Index i = 0; i < a.rows(); ++i) {
    for (Index j = 0; j < b.cols(); ++j) {
      for (Index k = 0; k < a.cols(); ++k) out(i, j) += a(i, k) * b(k, j);
    }
  }
  return out;
}

/// Multiplications of coupling m pairs of n coordinates, pairs (0,m), (1,m+1), …, and the FRFs, which must be the same.
struct CountedCoupling {
  std::size_t grc = 0;  ///< X S⁻¹ Xᵀ with an explicit inverse, the coupled coordinates once
  std::size_t mtc = 0;
  double difference = 0.0;
};

inline CountedCoupling count_multiplications(const ComplexMatrix& h, Index pairs) {
  const Index n = h.rows();
  const CountedMatrix counted = h.unaryExpr([](const Complex& z) { return Counted(z); });
  Conditions conditions;
  for (Index p = 0; p < pairs; ++p) conditions.push_back({p, p + pairs, 1.0});
  Wanted wanted;
  for (Index i = 0; i < n; ++i) {
    if (i < pairs || i >= 2 * pairs) wanted.rows.push_back(i);
  }
  wanted.columns = wanted.rows;
  CountedCoupling out;
  Counted::multiplications = 0;
  const CountedMatrix x = column_jumps(counted, conditions, wanted.rows), y = row_jumps(counted, conditions, wanted.columns);
  const CountedMatrix forces = product(gauss_jordan_inverse(jump_receptance(counted, conditions)), y);
  const CountedMatrix one = CountedMatrix(counted(wanted.rows, wanted.columns)) - product(x, forces);
  out.grc = Counted::multiplications;
  MtcSteps<Counted> steps(counted, pairs);
  Counted::multiplications = 0;
  for (const Condition& condition : conditions) steps.couple(condition);
  for (std::size_t r = 0; r < wanted.rows.size(); ++r) {
    for (std::size_t c = 0; c < wanted.columns.size(); ++c) {
      out.difference = std::max(out.difference, std::abs(steps(wanted.rows[r], wanted.columns[c]).value -
                                                         one(static_cast<Index>(r), static_cast<Index>(c)).value));
    }
  }
  out.mtc = Counted::multiplications;
  return out;
}

}  // namespace jointid::coupling
