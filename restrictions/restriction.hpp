#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "restrictions/joint_spec.hpp"
#include "restrictions/matrix_terms.hpp"

namespace jointid::restrictions {

/// One unknown of the joint.
struct Unknown {
  std::string name;  ///< "K(1,2)", "M.a", "K[4:+Y,5:+Y]"; prefixed "joint." when there are several joints
  std::string unit;  ///< "N/m", "N*m/rad", "kg", "N*s/m", …; "mixed" if an unknown has elements of several units
  Kind kind = Kind::stiffness;
  std::size_t joint = 0;  ///< index into the joints given to build()
};

/// The restriction matrix T of docs/formulas.md §4 (6.38), sparse and per matrix: x = T y₁ + T₂y₂. The unknowns y₁ are
/// `unknowns`; the known part T₂y₂ is already multiplied out. It has only matrices that the scene names.
struct Restriction {
  std::vector<frf::Dof> dofs;      ///< N joint DOFs, those of the joints one after the other
  /// K of all joints first, then M, C, D; within a matrix in order of first appearance, row by row; springs as listed.
  std::vector<Unknown> unknowns;
  std::vector<MatrixTerms> matrices;

  bool has(Kind kind) const;
  /// True when every matrix of every y is symmetric.
  bool symmetric() const;
  /// The N×N matrix (row-major) for the values `y` of all unknowns; zeros if the scene has no such matrix.
  std::vector<double> matrix(Kind kind, const std::vector<double>& y) const;
};

/// Builds T from the joints. Throws InputError (usage) with joint, matrix, entry and remedy. Causes: entries that are not linear,
/// wrong sizes, DOFs outside the joint, a DOF in two places, springs on one DOF, missing node positions, …
Restriction build(const std::vector<JointSpec>& joints);

}  // namespace jointid::restrictions
