#pragma once

#include <random>
#include <vector>

#include "frf/set/frf_set.hpp"
#include "restrictions/joint_spec.hpp"

namespace jointid::bench {

/// Two free structures of 14 random modes with 14 and 10 coordinates, the first two of each joined by a beam-like K and D =
/// K/100.
struct RandomSets {
  frf::FrfSet a, b, both;
};

RandomSets random_sets(std::size_t lines);

/// Two free structures of random modes, as many as coordinates, joined by springs with damping, each between a coordinate of the one and
/// one of the other.
struct SprungSets {
  RandomSets frfs;
  std::vector<restrictions::Spring> springs;
  std::vector<frf::Dof> dofs;  ///< of the joint
  std::vector<double> truth;   ///< stiffnesses, then hysteretic dampings
};

/// With `joint` coordinates at the joint and `others`, half of each on either structure.
SprungSets sprung_sets(std::size_t lines, std::size_t joint, std::size_t others);

/// Coordinates of the joint in `both`.
std::vector<frf::Dof> random_joint();

/// Upper triangles of K and D.
std::vector<double> true_unknowns();

/// Reciprocal circular errors of a level, whose variances the set tells.
void pollute(frf::FrfSet& set, double level, std::mt19937& generator);

}  // namespace jointid::bench
