#include "tasks/joint/node_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "tasks/joint/placed_nodes.hpp"

namespace jointid::tasks {
namespace {

constexpr double same_axis = 1e-6;

/// A pair that each of its nodes is the nearest of, and the usual distance of nodes in the two parts.
struct Near {
  NodePair pair;
  double usual = 0.0;
};

/// The axis of a direction at a node; the global one where the part says nothing of it.
std::array<double, 3> axis_of(const frf::FrfHeader& part, std::int64_t node, frf::Direction direction) {
  const auto place = std::ranges::find(part.nodes, node, &frf::Node::id);
  const frf::Axes axes = place == part.nodes.end() ? frf::global_axes : place->axes.value_or(frf::global_axes);
  return axes[(static_cast<std::size_t>(direction) - 1) % 3];
}

/// An axis that is not known is parallel to none.
bool are_parallel(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) <= same_axis;
}

const frf::Node* nearest_of(const frf::Node& node, const std::vector<frf::Node>& among) {
  const auto place = std::ranges::min_element(among, {}, [&](const frf::Node& other) { return distance(node, other); });
  return place == among.end() ? nullptr : &*place;
}

void add_near(const frf::FrfHeader& a, const frf::FrfHeader& b, std::vector<Near>& found) {
  const std::vector<frf::Node> of_a = placed_nodes(a), of_b = placed_nodes(b);
  if (of_a.empty() || of_b.empty()) return;
  const double usual = std::min(usual_distance(of_a), usual_distance(of_b));
  for (const frf::Node& node : of_a) {
    const frf::Node* const other = nearest_of(node, of_b);
    if (nearest_of(*other, of_a)->id != node.id) continue;
    NodePair pair = pair_of(a, node.id, b, other->id);
    pair.gap_m = distance(node, *other);
    if (!pair.directions.empty()) found.push_back({std::move(pair), usual});
  }
}

}  // namespace

std::vector<std::int64_t> couplable_nodes(const frf::FrfHeader& part) {
  std::set<std::int64_t> nodes;
  for (const frf::Dof& dof : couplable(part)) nodes.insert(dof.node);
  return {nodes.begin(), nodes.end()};
}

NodePair pair_of(const frf::FrfHeader& first_part, std::int64_t first, const frf::FrfHeader& second_part, std::int64_t second) {
  NodePair pair{first, second, {}};
  const std::vector<frf::Dof> there = couplable(second_part);
  for (const frf::Dof& dof : couplable(first_part)) {
    if (dof.node != first || !frf::has(there, {second, dof.direction})) continue;
    if (are_parallel(axis_of(first_part, first, dof.direction), axis_of(second_part, second, dof.direction)))
      pair.directions.push_back(dof.direction);
  }
  std::ranges::sort(pair.directions);
  return pair;
}

std::vector<NodePair> propose_pairs(const std::vector<const frf::FrfHeader*>& parts) {
  std::vector<Near> found;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.size(); ++j) add_near(*parts[i], *parts[j], found);
  }
  double least = std::numeric_limits<double>::infinity();
  for (const Near& each : found) least = std::min(least, *each.pair.gap_m);
  std::vector<NodePair> pairs;
  for (Near& each : found) {
    const double gap = *each.pair.gap_m;
    const bool finite = std::isfinite(each.usual);
    each.pair.likely = gap <= 2.0 * least || (finite && gap <= 0.05 * each.usual);
    if (each.pair.likely || (finite && gap <= 0.5 * each.usual)) pairs.push_back(std::move(each.pair));
  }
  std::ranges::stable_sort(pairs, {}, [](const NodePair& pair) { return std::pair(*pair.gap_m, pair.first); });
  return pairs;
}

}  // namespace jointid::tasks
