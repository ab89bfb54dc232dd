#pragma once

#include <random>
#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::bench {

/// Two free structures of 14 random modes with 14 and 10 coordinates, the first two of each joined by a beam-like K and D =
/// K/100.
struct RandomSets {
  frf::FrfSet a, b, both;
};

RandomSets random_sets(std::size_t lines);

/// Coordinates of the joint in `both`.
std::vector<frf::Dof> random_joint();

/// Upper triangles of K and D.
std::vector<double> true_unknowns();

/// Reciprocal circular errors of a level, whose variances the set tells.
void pollute(frf::FrfSet& set, double level, std::mt19937& generator);

}  // namespace jointid::bench
