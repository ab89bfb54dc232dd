#pragma once

#include "cli/oscillate/oscillate_scene.hpp"
#include "ident/scene/scene_reader.hpp"

namespace jointid::cli {

/// [system]; files of matrices are added to `scene.named`.
void read_system(const ident::SceneItem& item, OscillateScene& scene);

/// [friction]
oscillation::Friction read_friction(const ident::SceneItem& item);

}  // namespace jointid::cli
