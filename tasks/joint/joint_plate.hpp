#pragma once

#include <array>
#include <string>
#include <vector>

#include "tasks/joint/node_pairs.hpp"

namespace jointid::tasks {

/// A joint between two surfaces that move as rigid bodies there: the nodes of either side become one virtual point with six DOFs.
struct Plate {
  std::array<double, 3> position{};  ///< m, of both virtual points: the mean of all nodes, so that forces and moments pair off
  std::array<std::vector<frf::Dof>, 2> channels;  ///< of either side: sensors and impacts
};

/// The plate of pairs of nodes of two parts, from the directions of the pairs. Throws InputError (data) for fewer than two parts, nodes
/// without positions, and channels that do not determine all six motions (virtualpoint::transformation()), naming those left open.
Plate plate_of(const std::vector<NodePair>& pairs, const std::vector<frf::FrfHeader>& parts);

/// VP1:+X … VP1:+RZ, VP2:+X … VP2:+RZ.
std::vector<frf::Dof> plate_dofs();

/// What stands below the header of [[virtual_points]] for either side (0 or 1).
std::string virtual_point_text(const Plate& plate, std::size_t side);

}  // namespace jointid::tasks
