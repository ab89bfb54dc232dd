#include "modalfit/poles/clusters.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::modalfit {
namespace {

using Track = std::vector<CandidatePole>;

double decay(const CandidatePole& pole) { return pole.damping * pole.frequency_hz; }

/// Distance in the s-plane, Hz.
double distance(const CandidatePole& a, const CandidatePole& b) {
  return std::hypot(a.frequency_hz - b.frequency_hz, decay(a) - decay(b));
}

double reach(const CandidatePole& pole) {
  return std::max(0.5 * decay(pole), 3.0 * std::min(pole.deviation_hz, decay(pole)));
}

bool is_stable(const CandidatePole& pole, const ClusterOptions& options) {
  return pole.damping > 0.0 && pole.damping <= options.most_damping && std::isfinite(pole.deviation_hz);
}

struct Pair {
  double distance;
  std::size_t track, pole;
};

/// Joins the poles of an order to the tracks, nearest pairs first; what is left begins new ones.
void extend(std::vector<Track>& tracks, const std::vector<CandidatePole>& poles) {
  std::vector<Pair> pairs;
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    for (std::size_t p = 0; p < poles.size(); ++p) {
      const double d = distance(tracks[t].back(), poles[p]);
      if (d <= std::max(reach(tracks[t].back()), reach(poles[p]))) pairs.push_back({d, t, p});
    }
  }
  std::ranges::sort(pairs, {}, &Pair::distance);
  std::vector<bool> track_used(tracks.size()), pole_used(poles.size());
  for (const Pair& pair : pairs) {
    if (track_used[pair.track] || pole_used[pair.pole]) continue;
    track_used[pair.track] = pole_used[pair.pole] = true;
    tracks[pair.track].push_back(poles[pair.pole]);
  }
  for (std::size_t p = 0; p < poles.size(); ++p) {
    if (!pole_used[p]) tracks.push_back({poles[p]});
  }
}

Cluster cluster_of(const Track& track) {
  const auto later = track.begin() + static_cast<std::ptrdiff_t>(track.size() / 2);
  return {*std::min_element(later, track.end(), [](const auto& a, const auto& b) { return a.deviation_hz < b.deviation_hz; }),
          track.size()};
}

}  // namespace

std::vector<Cluster> cluster(const std::vector<OrderPoles>& orders, const ClusterOptions& options) {
  std::vector<Track> tracks;
  for (const OrderPoles& order : orders) {
    std::vector<CandidatePole> stable;
    std::ranges::copy_if(order.poles, std::back_inserter(stable), [&](const auto& pole) { return is_stable(pole, options); });
    extend(tracks, stable);
  }
  const std::size_t least = std::min(options.least_hits, std::max<std::size_t>(1, orders.size() / 2));
  std::vector<Cluster> found;
  for (const Track& track : tracks) {
    if (track.size() >= least) found.push_back(cluster_of(track));
  }
  std::ranges::sort(found, std::greater{}, &Cluster::hits);
  std::vector<Cluster> kept;
  for (const Cluster& each : found) {
    const auto alike = [&](const Cluster& other) {
      const double between = distance(each.pole, other.pole);
      const bool known = options.apart > 0.0 && between > options.apart * std::hypot(each.pole.deviation_hz, other.pole.deviation_hz);
      return !known && between < 0.5 * std::min(decay(each.pole), decay(other.pole));
    };
    if (std::ranges::none_of(kept, alike)) kept.push_back(each);
  }
  std::ranges::sort(kept, {}, [](const Cluster& each) { return each.pole.frequency_hz; });
  return kept;
}

}  // namespace jointid::modalfit
