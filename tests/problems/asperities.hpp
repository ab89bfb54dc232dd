#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "base/random.hpp"
#include "friction/curve/curve.hpp"

namespace jointid::problems {

/// Greenwood and Williamson's rough surface under tangential load: spheres of normally distributed heights (unit deviation), those
/// above `separation` touch with overlap z, carry a normal load z^{3/2} and slip as Mindlin says,
/// q = z^{3/2}(1 − (1 − u/z)^{3/2}) for u < z. None of the fitted laws; its limit is that of all spheres sliding.
class Asperities {
 public:
  explicit Asperities(double separation) : separation_(separation) {}

  double force(double u) const {
    constexpr double step = 0.002, end = 8.0;
    double sum = 0.0;
    for (double z = 0.5 * step; z < end; z += step) {
      const double height = z + separation_, stick = std::max(1.0 - u / z, 0.0);
      sum += step * std::exp(-0.5 * height * height) * z * std::sqrt(z) * (1.0 - stick * std::sqrt(stick));
    }
    return sum;
  }

  double limit() const { return force(100.0); }

  /// Loaded on `points` even steps until the force is `share` of the limit, with normal errors of `noise` times the largest force.
  friction::Curve curve(double share, std::size_t points, double noise) const {
    double low = 0.0, high = 100.0;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      (force(middle) < share * limit() ? low : high) = middle;
    }
    friction::Record record;
    for (std::size_t i = 1; i <= points; ++i) {
      record.displacement.push_back(high * static_cast<double>(i) / static_cast<double>(points));
      record.force.push_back(force(record.displacement.back()) + noise * share * limit() * normal_numbers({}, i)[0]);
    }
    return friction::loading_curve("asperities", std::move(record));
  }

 private:
  double separation_;
};

}  // namespace jointid::problems
