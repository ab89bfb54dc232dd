#pragma once

#include "response/harmonic/newton.hpp"
#include "response/harmonic/solution.hpp"

namespace jointid::response {

/// The first attempt that converged, or the last one that did not.
struct Attempt {
  NewtonResult result;
  Start start = Start::stuck;
  int steps = 0;  ///< of all attempts
};

/// Newton's method from the neighbour's motion (if any), from joints that stick and from joints without force, whichever is left
/// with the smaller residual first; then along levels from a small force to this one, along the
/// stiffness of springs in series with the joints (a way to very stiff ones), and with harmonics added one by one.
Attempt attempt_all(const CondensedEquations& equations, const HarmonicLine& line, double level,
                    const HarmonicSolution* neighbour);

/// The amplitudes of another solution, harmonics that it does not have being 0.
Eigen::VectorXd embedded(const CondensedEquations& equations, const std::vector<int>& harmonics,
                         const Eigen::MatrixXcd& amplitudes);

}  // namespace jointid::response
