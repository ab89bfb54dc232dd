#pragma once

#include "scene/reader.hpp"
#include "tasks/oscillate/oscillate_scene.hpp"

namespace jointid::tasks {

/// [system]; files of matrices are added to `scene.named`.
void read_system(const scene::Item& item, OscillateScene& scene);

/// [friction]
oscillation::Friction read_friction(const scene::Item& item);

}  // namespace jointid::tasks
