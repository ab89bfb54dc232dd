#pragma once

#include "gui/page/scene_page.hpp"

namespace jointid::gui {

/// Scenes whose friction laws `jointid solve` identifies from vibration: those with [[joint.friction]] or [[data.levels]].
SceneKind law_kind();

}  // namespace jointid::gui
