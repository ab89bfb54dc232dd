#pragma once

#include "report/oscillate/oscillate_scene.hpp"
#include "scene/reader.hpp"

namespace jointid::report {

/// [system]; files of matrices are added to `scene.named`.
void read_system(const scene::Item& item, OscillateScene& scene);

/// [friction]
oscillation::Friction read_friction(const scene::Item& item);

}  // namespace jointid::report
