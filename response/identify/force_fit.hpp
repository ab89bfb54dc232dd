#pragma once

#include <string>
#include <vector>

#include "response/identify/direct_step.hpp"
#include "response/joint/joint.hpp"

namespace jointid::response {

/// A law held against forces and motions of the direct step.
struct ForceFit {
  Joint joint;
  double chi_square = 0.0;   ///< Σ|F_n − F_n(Q; θ)|²/σ_F²
  Eigen::Index numbers = 0;  ///< F_n counted as real numbers
  bool converged = false;
  std::vector<Joint> family;  ///< the starts of the law's family that were nearest before, nearest first, at most three
};

/// The law of that name with the parameters that bring it nearest to the forces of joint `index` at its motions; `beside` gives
/// the joint's name, spring, dashpot and cubic spring, which are known. Starts where friction::Family does, with the stiffness of
/// the smallest motions and the largest force. The errors of Q are left out: parameters to start with, no estimate. Throws
/// InputError (data) when no step has harmonic 1, (usage) for a law that there is not.
ForceFit fit_forces(const std::vector<DirectStep>& steps, std::size_t index, const std::string& law, const Joint& beside = {});

}  // namespace jointid::response
