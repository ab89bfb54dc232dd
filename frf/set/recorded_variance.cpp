#include "frf/set/recorded_variance.hpp"

#include "frf/set/h1.hpp"

namespace jointid::frf {

bool knows_noise(const FrfSet& set) {
  return !set.variance.empty() || (!set.coherence.empty() && set.header.averages > 1.0);
}

Complex recorded_variance(const FrfSet& set, std::size_t at) {
  if (!set.variance.empty()) return set.variance[at];
  return h1_part_variances(set.values[at], set.coherence[at], set.header.averages);
}

}  // namespace jointid::frf
