#pragma once

#include "laws/scene/law_scene.hpp"

namespace jointid::laws {

/// Reads a scene. Everything that is wrong throws InputError (usage) with file, line, key and remedy.
LawScene read_law_scene(const ident::Path& file);

/// The same from text; `file` is used in messages and to resolve the paths of the data.
LawScene parse_law_scene(const std::string& text, const ident::Path& file);

}  // namespace jointid::laws
