#include "coupling/joint_loop.hpp"

#include "dense/lu.hpp"

namespace jointid::coupling {

ComplexMatrix joint_loop(const MatrixRef& h, const MatrixRef& z) {
  return ComplexMatrix::Identity(h.rows(), h.rows()) + h * z;
}

ComplexMatrix closed_loop(const MatrixRef& h, const MatrixRef& z) { return dense::inverse(joint_loop(h, z)); }

ComplexMatrix motion_with_joint(const MatrixRef& h, const MatrixRef& z, const MatrixRef& x) {
  return dense::solve(joint_loop(h, z), x);
}

ComplexMatrix force_with_joint(const MatrixRef& z, const MatrixRef& h, const MatrixRef& f) {
  return dense::solve(joint_loop(z, h), f);
}

ComplexMatrix motion_from_joint(const MatrixRef& x, const MatrixRef& z, const MatrixRef& h) {
  return dense::solve(joint_loop(z, h).transpose(), x.transpose()).transpose();
}

}  // namespace jointid::coupling
