#pragma once

#include <cstddef>
#include <vector>

namespace jointid::response {

/// The normal load on a joint over the time, over the one that its law belongs to: straight lines between (time, share), the
/// first and the last value beyond them; with a period the times of one period again and again. Slip limits of the joint are
/// proportional to it, stiffnesses are not (Ren 3.58); a share below 0 is no contact.
struct NormalLoad {
  std::vector<double> times, shares;  ///< s, ascending; N/N₀
  double period = 0.0;                ///< s; 0: none
  std::size_t sliders = 100;          ///< of algorithm A

  bool changes() const { return !times.empty(); }
  double at(double time) const;
};

}  // namespace jointid::response
