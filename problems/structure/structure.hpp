#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "frf/set/dof.hpp"
#include "frf/set/frf_set.hpp"
#include "restrictions/joint_spec.hpp"

namespace jointid::problems {

using restrictions::Kind;
using Matrix = std::vector<std::vector<double>>;  ///< rows of a small dense matrix

Matrix scaled(Matrix matrix, double factor);

/// A linear structure: K x + i D x + C ẋ + M ẍ = f over its DOFs, SI units (translations in m, rotations in
/// rad). Elements are added one after the other; nothing is scaled or eliminated.
class Structure {
 public:
  Structure() = default;

  /// A structure without any stiffness or mass. DOFs are distinct coordinates with a + sign.
  Structure(std::vector<frf::Node> nodes, std::vector<frf::Dof> dofs);

  const std::vector<frf::Node>& nodes() const { return nodes_; }
  const std::vector<frf::Dof>& dofs() const { return dofs_; }
  std::size_t size() const { return dofs_.size(); }

  /// Index of a DOF's coordinate; throws InputError (usage) when the structure does not have it.
  std::size_t index(const frf::Dof& dof) const;

  /// K, M, C or D, [n,n] row-major.
  const std::vector<double>& matrix(Kind kind) const { return matrices_[static_cast<std::size_t>(kind)]; }

  /// Adds the symmetric m×m matrix `element` at the given m DOFs.
  void add(Kind kind, const std::vector<frf::Dof>& at, const Matrix& element);

  /// k [1 −1; −1 1] between two DOFs, or k from a DOF to ground when `second` is empty (also masses and
  /// dampers).
  void add(Kind kind, const restrictions::Spring& spring, double value);

  /// D += factor·K: hysteretic damping proportional to the stiffness as it is now.
  void add_proportional_damping(double loss_factor);

 private:
  std::vector<frf::Node> nodes_;
  std::vector<frf::Dof> dofs_;
  std::array<std::vector<double>, restrictions::all_kinds.size()> matrices_;
};

/// Both structures side by side, not connected. Throws InputError (usage) when they share a coordinate.
Structure merged(const Structure& a, const Structure& b);

/// The structure with x(removed) = x(kept) and without the DOF `removed` (rigid connection): TᵀXT for K, M, C
/// and D.
Structure tied(const Structure& structure, const frf::Dof& kept, const frf::Dof& removed);

}  // namespace jointid::problems
