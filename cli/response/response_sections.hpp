#pragma once

#include "cli/response/response_scene.hpp"
#include "ident/scene/scene_reader.hpp"

namespace jointid::cli {

/// A coordinate of [structure] by its number from 1, or a DOF of the files of [data].
SceneDof read_dof(const ident::SceneItem& item, const ResponseScene& scene);

/// [structure]: matrices inline, or from files "m.mtx", "model.mat:M".
void read_structure(const ident::SceneItem& item, const ident::Path& folder, ResponseScene& scene);

/// One of [[joints]]; `number` counts from 1.
SceneJoint read_joint(const ident::SceneItem& item, const ResponseScene& scene, std::size_t number);

}  // namespace jointid::cli
