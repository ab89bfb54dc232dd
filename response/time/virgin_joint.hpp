#pragma once

#include <memory>

#include "response/time/joint_state.hpp"

namespace jointid::response {

/// A joint at rest that never moved: a slider for the bilinear law, a spring, a Masing path for any other law. `law` must outlive it.
std::unique_ptr<JointState> virgin_joint(const friction::Element& law);

}  // namespace jointid::response
