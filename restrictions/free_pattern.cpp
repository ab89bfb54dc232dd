#include <cmath>

#include "restrictions/local_matrix.hpp"
#include "restrictions/rigid_body.hpp"
#include "restrictions/unit.hpp"

namespace jointid::restrictions {
namespace {

constexpr Eigen::Index most_terms = 20'000'000;  // about 600 MB; a joint of some 80 DOFs
constexpr double farthest = 1e100;  // m; squares and differences stay finite

void check_positions(const JointSpec& joint, Kind kind) {
  for (const frf::Dof& dof : joint.dofs) {
    const auto found = joint.node_positions.find(dof.node);
    const std::string node = std::to_string(dof.node);
    if (found == joint.node_positions.end()) {
      fail(joint, kind, "pattern \"free\" needs the position of node " + node,
           "write \"" + node + "\" = [x, y, z] (m) under [nodes], or use pattern \"symmetric\"");
    }
    for (const double x : found->second) {
      if (!(std::abs(x) <= farthest)) fail(joint, kind, "the position of node " + node + " is out of range", "");
    }
  }
}

/// Terms of S(i,j): the symmetric part b_i b_jᵀ + b_j b_iᵀ (b_i b_iᵀ on the diagonal) of the columns b of V N.
void add_terms(LocalMatrix& matrix, const Eigen::MatrixXd& basis, Eigen::Index i, Eigen::Index j) {
  const std::size_t unknown = matrix.unknowns.size() - 1;
  for (Eigen::Index row = 0; row < basis.rows(); ++row) {
    for (Eigen::Index column = row; column < basis.rows(); ++column) {
      const double mirrored = i == j ? 0.0 : basis(row, j) * basis(column, i);
      const double coefficient = basis(row, i) * basis(column, j) + mirrored;
      const auto r = static_cast<std::size_t>(row);
      const auto c = static_cast<std::size_t>(column);
      matrix.terms.push_back({r, c, unknown, coefficient});
      if (c != r) matrix.terms.push_back({c, r, unknown, coefficient});
    }
  }
}

}  // namespace

LocalMatrix from_free_pattern(const JointSpec& joint, Kind kind) {
  check_positions(joint, kind);
  const Deformation deformed = deformation(joint.dofs, joint.node_positions);
  const Eigen::MatrixXd basis = deformed.scale.asDiagonal() * deformed.basis;
  if (basis.cols() == 0) {
    fail(joint, kind, "every motion of the joint's DOFs is a rigid-body motion, so pattern \"free\" leaves no unknown",
         "add DOFs, or use another pattern");
  }
  const Eigen::Index unknowns = basis.cols() * (basis.cols() + 1) / 2;
  if (unknowns * basis.rows() * basis.rows() > most_terms) {
    fail(joint, kind, "pattern \"free\" of " + std::to_string(basis.rows()) + " DOFs is too large: each of its " +
                          std::to_string(unknowns) + " unknowns is at every element",
         "split the joint, or use springs");
  }
  LocalMatrix matrix;
  const frf::Dof translation{};
  for (Eigen::Index i = 0; i < basis.cols(); ++i) {
    for (Eigen::Index j = i; j < basis.cols(); ++j) {
      const std::string name = symbol(kind) + ".s(" + std::to_string(i + 1) + "," + std::to_string(j + 1) + ")";
      matrix.unknowns.push_back({name, unit(kind, translation, translation)});
      add_terms(matrix, basis, i, j);
    }
  }
  return matrix;
}

}  // namespace jointid::restrictions
