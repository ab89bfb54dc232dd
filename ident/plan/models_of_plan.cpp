#include "ident/plan/models_of_plan.hpp"

namespace jointid::ident {

std::vector<UsedModel> used_models(const Plan& plan) {
  Dofs dofs = joined(joined(plan.coordinates.joint, plan.coordinates.responses), plan.coordinates.references);
  for (const auto& [first, second] : plan.scene.couple_first.pairs) {
    dofs.push_back(first);
    dofs.push_back(second);
  }
  return used_models(plan.models, plan.lines.size(), dofs);
}

}  // namespace jointid::ident
