#pragma once

#include "ident/scene/scene.hpp"

namespace jointid::ident {

/// Reads a scene. Unknown keys, wrong types, impossible values and combinations throw InputError (usage) that names file,
/// line, key and the nearest valid word.
Scene read_scene(const Path& file);

/// The same from text; `file` is used in messages and to resolve the paths of the data.
Scene parse_scene(const std::string& text, const Path& file);

}  // namespace jointid::ident
