#include "response/time/joint_path.hpp"

#include <utility>

#include "base/error.hpp"
#include "response/joint/cubic_spring.hpp"

namespace jointid::response {

JointPath::JointPath(const friction::Element& element, NormalLoad load)
    : path_(element), spring_(dynamic_cast<const CubicSpring*>(&element) != nullptr), load_(std::move(load)) {
  if (!load_.changes()) return;
  if (spring_) jointid::refuse("a spring has no normal load; name a joint with friction");
  sliders_.emplace(friction::even_sliders(element, load_.sliders));
  set_time(0.0);
}

void JointPath::set_time(double time) {
  if (sliders_) share_ = load_.at(time);
}

friction::Response JointPath::response(double q) const {
  if (sliders_) return sliders_->response(q, share_);
  return spring_ ? path_.element().response(q) : path_.response(q);
}

friction::Response JointPath::advance(double q) {
  if (sliders_) return sliders_->advance(q, share_);
  return spring_ ? path_.element().response(q) : path_.advance(q);
}

std::vector<JointPath> joint_paths(const JointedStructure& structure, const std::vector<NormalLoad>& loads) {
  if (!loads.empty() && loads.size() != structure.laws.size()) jointid::refuse("give a normal load for each joint, or none");
  std::vector<JointPath> paths;
  for (std::size_t j = 0; j < structure.laws.size(); ++j)
    paths.emplace_back(*structure.laws[j], loads.empty() ? NormalLoad{} : loads[j]);
  return paths;
}

}  // namespace jointid::response
