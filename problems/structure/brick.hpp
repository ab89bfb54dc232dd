#pragma once

#include <array>
#include <cstdint>

#include "problems/structure/structure.hpp"

namespace jointid::problems {

/// Isotropic linear elastic material.
struct Solid {
  double youngs_modulus = 0.0;  ///< N/m²
  double poissons_ratio = 0.0;
  double density = 0.0;  ///< kg/m³
};

/// The rectangular hexahedron of eight nodes with trilinear displacements, edges `size` (m) along x, y, z; 24 DOFs x, y, z of each
/// node, nodes in the order (0,0,0), (1,0,0), (1,1,0), (0,1,0), then the same at z = 1. K = ∫BᵀCB, M = ∫ρNᵀN (consistent), both by
/// 2×2×2 Gauss points, which is exact. Full integration: bending is too stiff for long elements (shear locking).
Matrix brick_stiffness(const Solid& solid, const std::array<double, 3>& size);
Matrix brick_mass(const Solid& solid, const std::array<double, 3>& size);

/// A rectangular block of equal bricks; DOFs +X, +Y, +Z of each node.
struct Block {
  std::int64_t first_node = 1;
  std::array<double, 3> origin{};        ///< m, its lowest corner
  std::array<double, 3> size{};          ///< m
  std::array<int, 3> elements{1, 1, 1};  ///< along x, y, z

  /// Number of the node at (i, j, k) elements from the lowest corner: first_node + i, then j, then k.
  std::int64_t node(int i, int j, int k) const {
    const std::int64_t in_row = elements[0] + 1, in_column = elements[1] + 1;
    return first_node + i + in_row * (j + in_column * k);
  }
};

/// Undamped, free on all sides.
Structure solid_block(const Solid& solid, const Block& block);

}  // namespace jointid::problems
