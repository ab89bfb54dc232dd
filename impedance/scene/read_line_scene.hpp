#pragma once

#include <filesystem>
#include <string>

#include "impedance/scene/line_scene.hpp"

namespace jointid::impedance {

/// Reads a scene whose [joint] has `lines`. Throws InputError (usage) with file, place, value and remedy.
LineScene parse_line_scene(const std::string& text, const std::filesystem::path& file);

}  // namespace jointid::impedance
