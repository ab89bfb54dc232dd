#include "response/condensation/condensation.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "dense/eigen.hpp"

namespace jointid::response {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

dense::SymmetricEigen modes_of(const JointedStructure& s, const MatrixXd& stiffness, Index count) {
  check(s);
  if (count < 1 || count > s.coordinates()) {
    throw InputError({.kind = ErrorKind::usage,
                      .file = {},
                      .place = "number of modes",
                      .problem = "is " + std::to_string(count),
                      .remedy = "give 1 to " + std::to_string(s.coordinates())});
  }
  return dense::symmetric_eigen(stiffness, s.matrices.mass);
}

}  // namespace

Basis free_modes(const JointedStructure& s, Index count) {
  return {modes_of(s, s.matrices.stiffness, count).vectors.leftCols(count), count, 0};
}

Basis lock_modes(const JointedStructure& s, Index count, const VectorXd& stiffness) {
  const MatrixXd locked = s.matrices.stiffness + s.incidence * stiffness.asDiagonal() * s.incidence.transpose();
  return {modes_of(s, locked, count).vectors.leftCols(count), count, 0};
}

/// What the left-out elastic modes give of K⁻¹W is M-orthogonal to the kept ones; Gram and Schmidt's process does the rest.
Basis free_and_attachment_modes(const JointedStructure& s, Index count) {
  const dense::SymmetricEigen modes = modes_of(s, s.matrices.stiffness, count);
  const double highest = modes.values.cwiseAbs().maxCoeff();
  MatrixXd columns = modes.vectors.leftCols(count);
  const Index others = s.coordinates() - count;
  const MatrixXd rest = modes.vectors.rightCols(others);
  VectorXd flexibility(others);
  for (Index r = 0; r < others; ++r) {
    const double square = modes.values[count + r];
    flexibility[r] = square > 1e-12 * highest ? 1.0 / square : 0.0;
  }
  for (Index j = 0; j < s.joints(); ++j) {
    // Coordinates of the deflection in the left-out modes, where M is the identity.
    VectorXd deflection = flexibility.asDiagonal() * (rest.transpose() * s.incidence.col(j));
    const double size = deflection.norm();
    const MatrixXd kept = rest.transpose() * (s.matrices.mass * columns.rightCols(columns.cols() - count));
    for (int again = 0; again < 2; ++again) deflection -= kept * (kept.transpose() * deflection);
    if (!(deflection.norm() > 1e-8 * size)) continue;
    columns.conservativeResize(Eigen::NoChange, columns.cols() + 1);
    columns.rightCols(1) = rest * deflection / deflection.norm();
  }
  return {columns, count, columns.cols() - count};
}

JointedStructure condense(const JointedStructure& s, const Basis& basis) {
  const MatrixXd& t = basis.columns;
  const auto project = [&](const MatrixXd& matrix) { return MatrixXd(t.transpose() * matrix * t); };
  return {{project(s.matrices.mass), project(s.matrices.damping), project(s.matrices.stiffness)},
          t.transpose() * s.incidence,
          s.laws};
}

}  // namespace jointid::response
