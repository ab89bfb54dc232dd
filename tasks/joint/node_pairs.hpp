#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "frf/set/frf_set.hpp"

namespace jointid::tasks {

/// A node of one part and one of another, where a bolt, a weld or a pad can join them.
struct NodePair {
  std::int64_t first = 0, second = 0;
  std::vector<frf::Direction> directions;  ///< ascending; in these both nodes can be coupled, along the same axis
  std::optional<double> gap_m{};           ///< between them; none where a position is not known
  bool likely = false;                     ///< the gap speaks for a joint there
};

/// Nodes of a part that have coordinates which are response and reference of it, ascending.
std::vector<std::int64_t> couplable_nodes(const frf::FrfHeader& part);

/// The pair of two such nodes of different parts. No directions where they share none, or their axes differ.
NodePair pair_of(const frf::FrfHeader& first_part, std::int64_t first, const frf::FrfHeader& second_part, std::int64_t second);

/// Pairs of nodes of different parts, each the nearest to the other, that share a direction; nearest first. Left out are those farther
/// apart than twice the nearest pair and half the usual distance of nodes in their parts (the median of the distance to the nearest).
/// `likely`: at most twice as far apart as the nearest pair, or a twentieth of the usual distance.
std::vector<NodePair> propose_pairs(const std::vector<const frf::FrfHeader*>& parts);

}  // namespace jointid::tasks
