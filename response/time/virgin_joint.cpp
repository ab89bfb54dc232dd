#include "response/time/virgin_joint.hpp"

#include "response/time/jenkins_state.hpp"
#include "response/time/masing_state.hpp"
#include "response/time/spring_state.hpp"

namespace jointid::response {

std::unique_ptr<JointState> virgin_joint(const friction::Element& law) {
  if (const auto* bilinear = dynamic_cast<const friction::Bilinear*>(&law)) return std::make_unique<JenkinsState>(*bilinear);
  if (const auto* spring = dynamic_cast<const CubicSpring*>(&law)) return std::make_unique<SpringState>(*spring);
  return std::make_unique<MasingState>(law);
}

}  // namespace jointid::response
