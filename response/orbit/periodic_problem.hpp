#pragma once

#include <Eigen/Core>
#include <vector>

#include "response/time/force_history.hpp"
#include "response/time/jointed_structure.hpp"

namespace jointid::response {

/// A structure and the periodic force on it, p(t) = Σ Re P_n e^{inωt}.
struct PeriodicProblem {
  JointedStructure structure;
  double omega = 0.0;           ///< rad/s
  std::vector<int> harmonics;   ///< n ≥ 0
  Eigen::MatrixXcd amplitudes;  ///< P_n, N × harmonics

  double period() const;
  ForceHistory force() const { return ForceHistory::periodic(omega, harmonics, amplitudes); }
};

}  // namespace jointid::response
