#pragma once

#include <string>
#include <vector>

#include "frf/uff/uff_lines.hpp"
#include "scene/reader.hpp"

namespace jointid::ident {

/// [geometry] lines of a scene: pairs of nodes that pictures join, which nothing is computed from. None without the table. Throws
/// InputError (usage) with the place for what is no pair of two nodes.
std::vector<frf::NodeLine> read_drawn_lines(const scene::Table& scene);

/// Those of a text, whatever else is wrong or missing in it; none where they cannot be read.
std::vector<frf::NodeLine> readable_lines(const std::string& text);

}  // namespace jointid::ident
