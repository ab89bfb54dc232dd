#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "problems/structure/structure.hpp"

namespace jointid::problems {

/// A joint between the ends of two beams, or of one beam and the ground: K and D over `dofs`.
struct BeamJoint {
  std::vector<frf::Dof> dofs;     ///< of the first part, then of the second
  std::vector<std::size_t> parts;  ///< one (to the ground) or two
  Matrix relative_stiffness;       ///< X_K: forces X_K (x_a − x_b) + i X_D (x_a − x_b)
  Matrix relative_damping;

  /// [X −X; −X X] over dofs, X alone to the ground.
  Matrix over_dofs(const Matrix& relative) const;
};

/// Many beams on many joints, and where the assembly is excited.
struct ManyJoints {
  std::vector<Structure> parts;  ///< nodes are numbered through, from 1; coordinates node by node
  std::vector<BeamJoint> joints;
  std::vector<frf::Dof> references;  ///< of the assembly
  std::vector<double> frequency_hz;
};

/// Equal elements of a beam; the length of part s is length·(1 + variation·sin(1.7 s + phase)).
struct BeamOfMany {
  std::size_t elements = 2;
  double length = 0.4, variation = 0.05, phase = 0.3;  ///< m
  double width = 0.03, height = 0.01;                  ///< m
  double youngs_modulus = 2.1e11, density = 7800.0, loss_factor = 0.004;
};

/// joints + 1 Euler–Bernoulli beams in a row along x, joint e between the last node of part e and the first of e + 1, relative 2 × 2
/// stiffness and damping in y and θ that vary along the row. References at y of the second node of every `spacing`-th part.
struct ChainOfBeams {
  BeamOfMany beam{};
  std::size_t joints = 50, spacing = 5;
  double translation = 2e5, rotation = 60.0, cross = 300.0, loss = 0.04;  ///< N/m, N·m/rad, N
};
ManyJoints chain_of_beams(const ChainOfBeams& chain);

/// A plane grid of nx × ny nodes with a beam between neighbours and a leg to the ground below each node of the first row; at each node
/// d ends of beams are joined by d − 1 joints of three springs, and a leg by one to the ground.
struct FrameOfBeams {
  BeamOfMany beam{.length = 0.5};
  std::size_t columns = 4, rows = 4, legs = 4, spacing = 9;
  double x = 4e6, y = 2e6, rotation = 300.0, loss = 0.03;  ///< N/m, N·m/rad
};
ManyJoints frame_of_beams(const FrameOfBeams& frame);

/// One long beam, the hub, with a beam of the chain joined to each of its inner nodes: the hub carries every joint.
ManyJoints star_of_beams(const ChainOfBeams& leaves);

/// Receptances of one part: all its coordinates to its joint coordinates and those references that are on it.
frf::FrfSet part_receptances(const ManyJoints& structure, std::size_t part);

/// Receptances of the assembly, all coordinates to all references, by a sparse LU decomposition a line, refined once in long double.
frf::FrfSet assembly_receptances(const ManyJoints& structure);

}  // namespace jointid::problems
