#pragma once

#include "impedance/scene/line_scene.hpp"
#include "scene/document.hpp"

namespace jointid::impedance {

/// Data, lines, variances and virtual points of a scene; its joint is still empty.
LineScene read_sections(const scene::Document& document, const std::filesystem::path& file);

}  // namespace jointid::impedance
