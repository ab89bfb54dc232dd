#pragma once

#include "gui/page/scene_page.hpp"

namespace jointid::gui {

/// Scenes of `jointid response`: those with a table [response].
SceneKind response_kind();

}  // namespace jointid::gui
