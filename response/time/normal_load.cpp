#include "response/time/normal_load.hpp"

#include <algorithm>
#include <cmath>

namespace jointid::response {

double NormalLoad::at(double time) const {
  const double t = period > 0.0 ? time - period * std::floor(time / period) : time;
  const auto after = std::ranges::upper_bound(times, t);
  if (after == times.begin()) return shares.front();
  if (after == times.end()) return shares.back();
  const auto next = static_cast<std::size_t>(after - times.begin());
  const double part = (t - times[next - 1]) / (times[next] - times[next - 1]);
  return shares[next - 1] + part * (shares[next] - shares[next - 1]);
}

}  // namespace jointid::response
