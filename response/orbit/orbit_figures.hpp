#pragma once

#include <Eigen/Core>
#include <vector>

#include "response/orbit/periodic_orbit.hpp"

namespace jointid::response {

/// What a period of an orbit tells.
struct OrbitFigures {
  Eigen::MatrixXcd x;         ///< X_n, N × harmonics: x = Σ Re X_n e^{inωt}; n = 0 is the mean
  Eigen::MatrixXcd q, f;      ///< Q_n, F_n of the joints, J × harmonics
  Eigen::VectorXd largest;    ///< max |x_i|, N
  Eigen::VectorXd loss;       ///< ∮ f dq of every joint, J (N m)
  double work = 0.0;          ///< ∮ pᵀẋ dt
  double damping_loss = 0.0;  ///< ∮ ẋᵀCẋ dt; work = Σ loss + damping_loss to 1e-12
};

/// Integrals over the period by Gauss's rule on every step of the march, events at their ends.
OrbitFigures figures(const PeriodicProblem& problem, const PeriodicOrbit& orbit, const std::vector<int>& harmonics,
                     const MarchOptions& options = {});

}  // namespace jointid::response
