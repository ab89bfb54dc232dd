#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "problems/structure/structure.hpp"

namespace jointid::problems {

/// A round bar.
struct BarSection {
  double diameter = 0.0;        ///< m
  double youngs_modulus = 0.0;  ///< N/m²
  double poissons_ratio = 0.3;
  double density = 0.0;  ///< kg/m³
};

/// Stiffness of an Euler–Bernoulli bar in space from the first end to the second, `axis` m away, over x, y, z, rx, ry, rz of each
/// end in global axes: tension, torsion, bending in both planes.
Matrix frame_stiffness(const BarSection& section, const std::array<double, 3>& axis);

/// Bars through nodes one after the other, DOFs x, y, z, rx, ry, rz of each. A bar's mass and its mass times diameter²/8 as
/// rotational inertia go half to each of its ends. Undamped.
Structure frame(const BarSection& section, const std::vector<frf::Node>& nodes);

/// The six DOFs of a node.
std::vector<frf::Dof> frame_dofs(std::int64_t node);

}  // namespace jointid::problems
