#include "ident/start_plan.hpp"

#include "base/error.hpp"
#include "ident/scene_failure.hpp"

namespace jointid::ident {

std::unique_ptr<Plan> plan_start(const Plan& plan, const std::vector<std::pair<Method, std::vector<Equation>>>& choices) {
  Scene scene = plan.scene;
  scene.identify = {};
  for (restrictions::JointSpec& joint : scene.joints) joint.definite.clear();
  scene.couple_first = {};  // done already
  for (const auto& [method, equations] : choices) {
    scene.identify.method = method;
    scene.identify.equations = equations;
    try {
      return make_plan(scene, plan.substructures, plan.assembly);
    } catch (const InputError&) {
      // The next one needs less.
    }
  }
  fail(plan.scene, "[identify] start", "the data allow no linear estimate to start from", "add start = { … } to [identify]");
}

}  // namespace jointid::ident
