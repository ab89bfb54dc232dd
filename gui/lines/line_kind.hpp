#pragma once

#include "gui/page/scene_page.hpp"

namespace jointid::gui {

/// Scenes of the joint at every line, [joint] lines: Z over frequency with its bands, loss factors, laws, misfit by line.
SceneKind line_kind();

}  // namespace jointid::gui
