#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frf/set/dof.hpp"
#include "ident/result/used_model.hpp"

namespace jointid::models {
class Model;
}

namespace jointid::ident {

/// A file of a scene that describes a model, and what computes its FRFs.
struct ModelInUse {
  std::string file;
  std::vector<frf::Dof> dofs;  ///< with the corrections of the scene
  std::shared_ptr<const models::Model> model;
};

using ModelsInUse = std::vector<ModelInUse>;

/// What they did so far, and what they will take for so many lines between those of the DOFs that they have.
std::vector<UsedModel> used_models(const ModelsInUse& models, std::size_t lines, const std::vector<frf::Dof>& dofs);

}  // namespace jointid::ident
