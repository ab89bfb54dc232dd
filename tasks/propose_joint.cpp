#include "tasks/propose_joint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/text.hpp"
#include "tasks/joint/placed_nodes.hpp"

namespace jointid::tasks {
namespace {

using Headers = std::vector<const frf::FrfHeader*>;
using Dofs = std::vector<frf::Dof>;

constexpr double equally_near = 1.01;  // as the nearest pair

struct NearNode {
  frf::Node node;
  double gap = 0.0, usual = 0.0;
};

/// Of every node the distance to the nearest node of another part.
std::vector<NearNode> gaps(const Headers& parts) {
  std::vector<std::vector<frf::Node>> nodes;
  for (const frf::FrfHeader* part : parts) nodes.push_back(placed_nodes(*part));
  std::vector<NearNode> found;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (nodes[i].empty()) continue;
    const double usual = usual_distance(nodes[i]);
    for (const frf::Node& node : nodes[i]) {
      double gap = std::numeric_limits<double>::infinity();
      for (std::size_t j = 0; j < parts.size(); ++j) {
        if (j != i) gap = std::min(gap, nearest(node, nodes[j]));
      }
      found.push_back({node, gap, usual});
    }
  }
  return found;
}

Dofs at_nodes(const Headers& parts, const std::set<std::int64_t>& nodes) {
  Dofs dofs;
  for (const frf::FrfHeader* part : parts) {
    for (const frf::Dof& dof : couplable(*part)) {
      if (nodes.contains(dof.node)) dofs.push_back(dof);
    }
  }
  std::ranges::stable_sort(dofs, {}, [](const frf::Dof& dof) { return frf::coordinate_key(dof); });
  return dofs;
}

std::string listed(const std::set<std::int64_t>& nodes) {
  return comma_list(nodes, [](std::int64_t node) { return std::to_string(node); });
}

}  // namespace

ProposedJoint propose_joint(const Headers& parts) {
  ProposedJoint joint;
  const std::vector<NearNode> all = gaps(parts);
  double least = std::numeric_limits<double>::infinity();
  for (const NearNode& node : all) least = std::min(least, node.gap);
  if (!std::isfinite(least)) {
    joint.doubts.push_back(
        "Joint DOFs: the files have no node positions, or only those of one part; name the DOFs on both sides of the joint.");
    return joint;
  }
  std::set<std::int64_t> near, nearest_ones;
  for (const NearNode& node : all) {
    if (node.gap <= 0.5 * node.usual && std::isfinite(node.usual)) near.insert(node.node.id);
    if (node.gap <= equally_near * least) nearest_ones.insert(node.node.id);
  }
  const bool by_spacing = std::ranges::includes(near, nearest_ones);
  const std::set<std::int64_t>& chosen = by_spacing ? near : nearest_ones;
  joint.dofs = at_nodes(parts, chosen);
  joint.reasons.push_back("Joint DOFs: nodes " + listed(chosen) +
                          (by_spacing ? " lie nearer to another part than half the usual distance of nodes in their own"
                                      : " are those of different parts that lie nearest to each other") +
                          "; the smallest gap is " + digits(least, "%.3g") + " m.");
  joint.doubts.push_back("Only node positions locate the joint: check its DOFs.");
  return joint;
}

}  // namespace jointid::tasks
