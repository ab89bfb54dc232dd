#include <cassert>
#include <limits>

#include "base/eigen.hpp"
#include "coupling/methods.hpp"
#include "dense/lu.hpp"

namespace jointid::coupling {
namespace {

/// T of x = T x_asm with entries 0, 1, −1: coordinates that conditions tie share a column, grounded ones have none.
Eigen::MatrixXd assembly_matrix(Index coordinates, const Conditions& conditions) {
  Eigen::MatrixXd t = Eigen::MatrixXd::Identity(coordinates, coordinates);
  std::vector<Index> gone;
  for (const Condition& condition : conditions) {
    // b = T's combination that must vanish; its column with an entry is expressed by the others.
    Eigen::RowVectorXd b = t.row(condition.first);
    if (condition.second) b -= condition.sign * t.row(*condition.second);
    Index pivot = 0;
    b.cwiseAbs().maxCoeff(&pivot);
    assert(b[pivot] != 0.0);
    const Eigen::VectorXd column = t.col(pivot) / b[pivot];
    t -= column * b;
    gone.push_back(pivot);
  }
  std::sort(gone.begin(), gone.end());
  Eigen::MatrixXd out(coordinates, coordinates - at(gone.size()));
  Index to = 0;
  for (Index column = 0; column < coordinates; ++column) {
    if (!std::binary_search(gone.begin(), gone.end(), column)) out.col(to++) = t.col(column);
  }
  return out;
}

}  // namespace

ComplexMatrix gic(const MatrixRef& h, const Conditions& conditions, const Wanted& wanted) {
  assert(h.rows() == h.cols());
  const ComplexMatrix t = assembly_matrix(h.rows(), conditions).cast<Complex>();
  const ComplexMatrix z = dense::inverse(h);
  const ComplexMatrix assembled = t * dense::solve(t.transpose() * z * t, t.transpose());
  return assembled(wanted.rows, wanted.columns);
}

}  // namespace jointid::coupling
