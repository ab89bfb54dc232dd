#include "tasks/joint/placed_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/statistics.hpp"

namespace jointid::tasks {

std::vector<frf::Dof> couplable(const frf::FrfHeader& part) {
  std::vector<frf::Dof> dofs;
  for (const frf::Dof& dof : part.response) {
    if (frf::has(part.reference, dof)) dofs.push_back(dof);
  }
  return dofs;
}

std::vector<frf::Node> placed_nodes(const frf::FrfHeader& part) {
  std::set<std::int64_t> wanted;
  for (const frf::Dof& dof : couplable(part)) wanted.insert(dof.node);
  std::vector<frf::Node> nodes;
  for (const frf::Node& node : part.nodes) {
    if (wanted.contains(node.id)) nodes.push_back(node);
  }
  return nodes;
}

double distance(const frf::Node& a, const frf::Node& b) {
  return std::hypot(a.position[0] - b.position[0], a.position[1] - b.position[1], a.position[2] - b.position[2]);
}

double nearest(const frf::Node& node, const std::vector<frf::Node>& among) {
  double least = std::numeric_limits<double>::infinity();
  for (const frf::Node& other : among) {
    if (&other != &node) least = std::min(least, distance(node, other));
  }
  return least;
}

double usual_distance(const std::vector<frf::Node>& nodes) {
  std::vector<double> each;
  for (const frf::Node& node : nodes) each.push_back(nearest(node, nodes));
  return median(each);
}

}  // namespace jointid::tasks
