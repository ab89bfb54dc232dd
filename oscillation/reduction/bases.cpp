#include "oscillation/reduction/bases.hpp"

#include <cmath>
#include <string>

#include "base/error.hpp"
#include "dense/cholesky.hpp"
#include "dense/eigen.hpp"
#include "dense/svd.hpp"

namespace jointid::oscillation {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void check_count(Index count, Index most) {
  if (count >= 1 && count <= most) return;
  throw InputError({ErrorKind::usage, "", "orders", std::to_string(count) + " is not from 1 to " + std::to_string(most),
                    "a reduced model has at most as many coordinates as the full one"});
}

/// An orthonormal basis of what is at right angles to p.
MatrixXd held(const VectorXd& p) {
  return dense::svd(p.transpose(), dense::Vectors::none, dense::Vectors::full).v.rightCols(p.size() - 1);
}

MatrixXd weighted(const Mechanics& full, const ReductionBasis& basis, const VectorXd& q) {
  const MatrixXd left = basis.columns.transpose() * full.mass;
  return dense::solve_positive(left * basis.columns, MatrixXd(left * q));
}

}  // namespace

ReductionBasis normal_modes(const Mechanics& mechanics, Index count) {
  const Index n = mechanics.contact.size();
  check_count(count, n);
  return {dense::symmetric_eigen(mechanics.stiffness, mechanics.mass).vectors.leftCols(count), VectorXd::Zero(n)};
}

ReductionBasis craig_bampton(const Mechanics& mechanics, Index count) {
  const Index n = mechanics.contact.size();
  check_count(count, n);
  const auto lower = dense::cholesky(mechanics.stiffness);
  if (!lower) {
    throw InputError({ErrorKind::usage, "", "craig_bampton",
                      "the structure is not held: a force at the contact has no static shape",
                      "reduce it on normal modes or proper orthogonal modes"});
  }
  ReductionBasis out{MatrixXd(n, count), VectorXd::Zero(n)};
  VectorXd shape = dense::solve_positive(mechanics.stiffness, MatrixXd(mechanics.contact));
  if (count > 1) {
    const MatrixXd free = held(mechanics.contact);
    const dense::SymmetricEigen fixed =
        dense::symmetric_eigen(free.transpose() * mechanics.stiffness * free, free.transpose() * mechanics.mass * free);
    out.columns.rightCols(count - 1) = free * fixed.vectors.leftCols(count - 1);
  }
  for (int pass = 0; pass < 2; ++pass) {
    const MatrixXd others = out.columns.rightCols(count - 1);
    shape -= others * (others.transpose() * (mechanics.mass * shape));
  }
  out.columns.col(0) = shape / std::sqrt(shape.dot(mechanics.mass * shape));
  return out;
}

ReductionBasis proper_modes(const oscillation::Pod& pod, Index count) {
  check_count(count, pod.modes.cols());
  return {pod.modes.leftCols(count), pod.mean};
}

Mechanics reduced(const Mechanics& full, const ReductionBasis& basis) {
  const MatrixXd& phi = basis.columns;
  if (phi.rows() != full.contact.size() || basis.mean.size() != full.contact.size() || phi.cols() == 0) {
    throw InputError({ErrorKind::usage, "", "basis", "has another number of rows than the system has coordinates", ""});
  }
  Mechanics out;
  out.mass = phi.transpose() * full.mass * phi;
  out.damping = phi.transpose() * full.damping * phi;
  out.stiffness = phi.transpose() * full.stiffness * phi;
  out.contact = phi.transpose() * full.contact;
  out.constant = -phi.transpose() * full.stiffness * basis.mean;
  if (full.constant.size() > 0) out.constant += phi.transpose() * full.constant;
  if (full.forcing.size() > 0) out.forcing = phi.transpose() * full.forcing;
  return out;
}

Friction reduced(const Friction& friction, const Mechanics& full, const ReductionBasis& basis) {
  Friction out = friction;
  out.normal += friction.normal_slope * full.contact.dot(basis.mean);
  return out;
}

VectorXd reduced_displacements(const Mechanics& full, const ReductionBasis& basis, const VectorXd& q) {
  return weighted(full, basis, q - basis.mean);
}

VectorXd reduced_velocities(const Mechanics& full, const ReductionBasis& basis, const VectorXd& v) {
  return weighted(full, basis, v);
}

}  // namespace jointid::oscillation
