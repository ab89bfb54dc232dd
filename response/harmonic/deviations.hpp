#pragma once

#include <vector>

#include "response/harmonic/harmonic_balance.hpp"

namespace jointid::response {

/// A parameter of a joint that is known up to a standard deviation.
struct ParameterDeviation {
  JointParameter parameter;
  double deviation = 0.0;
};

/// Standard deviations of a response, [harmonic, response].
struct ResponseDeviations {
  Eigen::MatrixXcd parts;     ///< of Re X_n and Im X_n
  Eigen::MatrixXd amplitude;  ///< of |X_n|
};

/// To first order, of the structure's errors at every nω (Receptance::errors) and of the joints' parameters, all independent.
/// With δu = δH(P − WF): J δQ = Wᵀδu, δX = δu − HW ∂F/∂Q δQ; for a parameter J δQ = −G ∂F/∂θ δθ, δX = −HW(∂F/∂Q δQ + ∂F/∂θ δθ).
/// The solution must have converged.
ResponseDeviations deviations(const HarmonicBalance& balance, const HarmonicSolution& solution,
                              const std::vector<ParameterDeviation>& parameters = {});

}  // namespace jointid::response
