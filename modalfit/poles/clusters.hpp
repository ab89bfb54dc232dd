#pragma once

#include <vector>

#include "modalfit/poles/polyreference.hpp"

namespace jointid::modalfit {

/// A pole that came again from order to order.
struct Cluster {
  CandidatePole pole;    ///< of the later half of the orders, the one with the smallest deviation
  std::size_t hits = 0;  ///< orders it came in
};

struct ClusterOptions {
  double most_damping = 0.3;    ///< poles with 0 < ζ ≤ this
  std::size_t least_hits = 4;   ///< orders, or half of them where there are fewer than twice as many
  /// Clusters nearer than half the smaller decay rate both stay where they are this many of their standard deviations apart; 0: never.
  double apart = 0.0;
};

/// Follows stable poles from order to order: a pole joins the nearest track whose last pole is no farther than half its decay rate
/// ζf, or three standard deviations (of at most ζf each), and no pole joins twice. Of two clusters nearer than half the smaller decay
/// rate the one with more hits stays. Ascending frequencies. What noise makes is left for the significance test.
std::vector<Cluster> cluster(const std::vector<OrderPoles>& orders, const ClusterOptions& options);

}  // namespace jointid::modalfit
