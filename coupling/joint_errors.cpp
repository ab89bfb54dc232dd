#include "coupling/joint_errors.hpp"

#include "base/eigen.hpp"

namespace jointid::coupling {
namespace {

/// L M for rows whose 1 behind the first b columns is left out of L.
ComplexMatrix left_times(const ComplexMatrix& left, const ComplexMatrix& m, const std::vector<Index>& rows) {
  ComplexMatrix out = left * m.topRows(left.cols());
  for (Index r = 0; r < out.rows(); ++r) {
    const Index own = rows[static_cast<std::size_t>(r)];
    if (own >= left.cols()) out.row(r) += m.row(own);
  }
  return out;
}

/// M R likewise.
ComplexMatrix times_right(const ComplexMatrix& m, const ComplexMatrix& right, const std::vector<Index>& columns) {
  ComplexMatrix out = m.leftCols(right.rows()) * right;
  for (Index c = 0; c < out.cols(); ++c) {
    const Index own = columns[static_cast<std::size_t>(c)];
    if (own >= right.rows()) out.col(c) += m.col(own);
  }
  return out;
}

}  // namespace

void add_joint_errors(const JointErrorTerms& terms, const std::vector<ComplexMatrix>& common, LineVariance& variance) {
  const auto& [conditions, all, with_joint, joint, omega, wanted] = terms;
  const ComplexMatrix to = left_times(conditions.left, with_joint(Eigen::all, joint.at), wanted.rows);
  const ComplexMatrix from = times_right(with_joint(joint.at, Eigen::all), conditions.right, wanted.columns);
  const std::size_t unknowns = joint.by_unknown.size();
  std::vector<ComplexMatrix> by, shared;  // D_m, and E[(L ε R) θ_m]
  for (std::size_t m = 0; m < unknowns; ++m) {
    by.emplace_back(-to * joint.by_unknown[m].dynamic_stiffness(omega) * from);
    shared.push_back(times_right(left_times(all.left, common[m], wanted.rows), all.right, wanted.columns));
  }
  for (std::size_t m = 0; m < unknowns; ++m) {
    ComplexMatrix sum = 2.0 * shared[m];
    for (std::size_t n = 0; n < unknowns; ++n) sum += Complex(joint.covariance(at(m), at(n))) * by[n];
    variance.real += by[m].real().cwiseProduct(sum.real());
    variance.imaginary += by[m].imag().cwiseProduct(sum.imag());
  }
  for (std::size_t c = 0; c < variance.covariance.size(); ++c) {
    for (std::size_t m = 0; m < unknowns; ++m) {
      const auto column = at(c);
      Eigen::VectorXcd half = shared[m].col(column);
      for (std::size_t n = 0; n < unknowns; ++n) half += Complex(0.5 * joint.covariance(at(m), at(n))) * by[n].col(column);
      const ComplexMatrix one_side = by[m].col(column) * half.adjoint();
      variance.covariance[c] += one_side + one_side.adjoint();
    }
  }
}

}  // namespace jointid::coupling
