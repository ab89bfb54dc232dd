
#include "base/eigen.hpp"
#include "coupling/methods.hpp"
#include "dense/lu.hpp"

namespace jointid::coupling {

ComplexMatrix with_joint(const MatrixRef& h, const std::vector<Index>& at, const MatrixRef& z) {
  const auto n = jointid::at(at.size());
  const ComplexMatrix h_jj = h(at, at);
  const ComplexMatrix rows = h(at, Eigen::all);
  const ComplexMatrix columns = h(Eigen::all, at);
  const ComplexMatrix system = ComplexMatrix::Identity(n, n) + z * h_jj;
  return h - columns * dense::solve(system, z * rows);
}

}  // namespace jointid::coupling
