#pragma once

#include <string>
#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::tasks {

struct ProposedJoint {
  std::vector<frf::Dof> dofs;  ///< empty where nothing speaks for any
  std::vector<std::string> reasons, doubts;
};

/// Joint DOFs of parts that have positions of their nodes: all coordinates that are response and reference of their part, at
/// nodes that lie nearer to a node of another part than half the usual distance of nodes in their own (the median over nodes of
/// the distance to the nearest); where no node does, at those that are nearest.
ProposedJoint propose_joint(const std::vector<const frf::FrfHeader*>& parts);

}  // namespace jointid::tasks
