#include "ident/plan/model_in_use.hpp"

#include <algorithm>

#include "frf/set/frf_set.hpp"
#include "models/model.hpp"

namespace jointid::ident {

std::vector<UsedModel> used_models(const ModelsInUse& models, std::size_t lines, const std::vector<frf::Dof>& dofs) {
  std::vector<UsedModel> out;
  for (const ModelInUse& each : models) {
    const auto asked = std::ranges::count_if(each.dofs, [&](const frf::Dof& dof) { return frf::has(dofs, dof); });
    out.push_back({each.file, each.model->use(lines, static_cast<std::size_t>(asked))});
  }
  return out;
}

}  // namespace jointid::ident
