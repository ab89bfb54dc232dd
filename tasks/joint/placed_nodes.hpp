#pragma once

#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::tasks {

/// The coordinates with which a part can be coupled: those that are response and reference of it.
std::vector<frf::Dof> couplable(const frf::FrfHeader& part);

/// Nodes of a part that have such coordinates and a position.
std::vector<frf::Node> placed_nodes(const frf::FrfHeader& part);

/// m
double distance(const frf::Node& a, const frf::Node& b);

/// The distance to the nearest of some nodes, but for itself among them; infinite where there is none.
double nearest(const frf::Node& node, const std::vector<frf::Node>& among);

/// The median over nodes of the distance to the nearest of the same part; infinite for a part of one node.
double usual_distance(const std::vector<frf::Node>& nodes);

}  // namespace jointid::tasks
