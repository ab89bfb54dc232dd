#pragma once

#include <string>
#include <vector>

#include "laws/task/identify_laws.hpp"

namespace jointid::laws {

/// What the levels tell of the joints without any law: F and Q of every state.
struct DirectIdentification {
  Status status = Status::ok;  ///< ok, doubtful or poor_fit
  std::string message;
  LevelStates data;
  response::Consistency consistency;
  std::vector<response::DirectStep> steps;  ///< of each state
  std::vector<OneSidedJoint> one_sided;     ///< of every joint
  std::vector<std::size_t> known;           ///< of every joint how many states tell F₁/Q₁ to 30 %
  std::vector<std::string> notes;
};

/// Reads the files of a scene and takes the direct step (response::direct_step) of every state. `doubtful` where no state tells
/// the stiffness of a joint to 30 % (the parts move far more than the joint, so that Q = b − GF is a difference of like numbers,
/// or the responses do not see it), and where a force has even harmonics; `poor_fit` where the data contradict each other. Throws
/// InputError as identify_laws().
DirectIdentification identify_directly(const LawScene& scene);

}  // namespace jointid::laws
