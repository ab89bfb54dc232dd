#pragma once

#include "gui/page/scene_page.hpp"

namespace jointid::gui {

/// Scenes of `jointid oscillate`: those with a table [motion].
SceneKind oscillate_kind();

}  // namespace jointid::gui
