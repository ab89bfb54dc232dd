#pragma once

#include "tasks/response/response_scene.hpp"

namespace jointid::tasks {

/// Reads a scene and the matrices that it names. Throws InputError (usage; data for matrices).
ResponseScene read_response_scene(const ident::Path& file);

/// The same from text; `file` is used in messages and to resolve paths.
ResponseScene parse_response_scene(const std::string& text, const ident::Path& file);

}  // namespace jointid::tasks
