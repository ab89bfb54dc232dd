#pragma once

#include <cstddef>
#include <vector>

#include "base/complex.hpp"
#include "oscillation/tangent/spectrum.hpp"

namespace jointid::oscillation {

/// A point that a map takes to itself, stable or not.
struct PeriodicPoint {
  Eigen::VectorXd state;
  std::vector<Complex> multipliers;  ///< of the map's derivative, the largest modulus first
  double residual = 0.0;             ///< largest |P(z) − z|
  std::size_t iterations = 0;
  bool converged = false;  ///< residual ≤ 1e-9 (1 + largest |z|); Newton goes on while it falls
};

/// Newton's method on P(z) − z, P the step applied `times` times, by least squares of smallest norm (some coordinates may be
/// fixed by the step). Steps are halved while the residual grows.
PeriodicPoint periodic_point(const TangentStep& step, const Eigen::VectorXd& start, std::size_t times = 1,
                             std::size_t most_iterations = 50);

}  // namespace jointid::oscillation
