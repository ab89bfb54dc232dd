#pragma once

#include <cstdint>
#include <vector>

#include "problems/structure/structure.hpp"

namespace jointid::problems {

/// A prismatic Euler–Bernoulli beam of rectangular section along x that bends in the x-y plane.
struct BeamSection {
  double width = 0.0;           ///< m, along z
  double thickness = 0.0;       ///< m, along y
  double youngs_modulus = 0.0;  ///< N/m²
  double density = 0.0;         ///< kg/m³
};

/// Stiffness and consistent mass matrix of one element of `length` over {y₁, θ₁, y₂, θ₂}, docs/formulas.md §13 with
/// I = wh³/12 and m = ρwh (the matrices printed there are rounded).
Matrix element_stiffness(const BeamSection& section, double length);
Matrix element_mass(const BeamSection& section, double length);

/// A chain of elements through nodes at (x, y) with ids first_node, first_node+1, …, DOFs +Y and +RZ of each.
/// Undamped.
struct BeamLine {
  std::int64_t first_node = 1;
  std::vector<double> x;  ///< m, increasing, at least two
  double y = 0.0;         ///< m, only for the node positions
};
Structure beam(const BeamSection& section, const BeamLine& line);

/// The DOFs +Y and +RZ of a node.
std::vector<frf::Dof> beam_dofs(std::int64_t node);

}  // namespace jointid::problems
