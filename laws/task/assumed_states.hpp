#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "laws/data/level_states.hpp"
#include "response/joint/joint.hpp"

namespace jointid::laws {

/// What the levels of a scene would be without noise, for laws that are assumed.
struct AssumedStates {
  std::vector<response::Joint> joints;
  std::vector<std::string> laws;  ///< of each joint
  bool told = true;               ///< the laws are those of the scene, else those that the measured levels give
  std::vector<int> harmonics;     ///< of the model: those of the scene, else 1, 3, … 9 that the parts have at every line
  LevelStates data;               ///< exact, with the deviations that [errors] and files tell
};

/// Reads the parts (and the measured levels) and solves harmonic balance at each level and line; states without a solution are left
/// out, and told. Of a planned level at least a thousandth of the largest harmonic of a response counts as the size of the others.
/// Throws InputError (data) without laws to assume, and without [errors] for a planned level.
AssumedStates assumed_states(const LawScene& scene);

/// The responses of the assumed laws to the forces of a state, over a structure that may be another one; none where harmonic balance
/// has no solution.
std::optional<Eigen::MatrixXcd> responses_of(const AssumedStates& assumed, const std::shared_ptr<const response::Receptance>& structure,
                                             const response::MeasuredState& state);

}  // namespace jointid::laws
