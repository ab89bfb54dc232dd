#include "coupling/joint_loop.hpp"
#include "coupling/methods.hpp"

namespace jointid::coupling {

ComplexMatrix with_joint(const MatrixRef& h, const std::vector<Index>& at, const MatrixRef& z) {
  const ComplexMatrix h_jj = h(at, at);
  const ComplexMatrix rows = h(at, Eigen::all);
  const ComplexMatrix columns = h(Eigen::all, at);
  return h - columns * force_with_joint(z, h_jj, z * rows);
}

}  // namespace jointid::coupling
