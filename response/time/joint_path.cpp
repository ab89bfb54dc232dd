#include "response/time/joint_path.hpp"

#include "response/joint/cubic_spring.hpp"

namespace jointid::response {

JointPath::JointPath(const friction::Element& element)
    : path_(element), spring_(dynamic_cast<const CubicSpring*>(&element) != nullptr) {}

}  // namespace jointid::response
