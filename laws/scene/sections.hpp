#pragma once

#include "scene/reader.hpp"
#include "ident/scene/scene_sections.hpp"
#include "laws/scene/law_scene.hpp"

namespace jointid::laws {

/// [[data.levels]]; `names` gets the files as written, in the order of level_files().
void read_levels(const scene::Item& item, const ident::Path& folder, LawScene& scene, std::vector<std::string>& names);

/// The files of all levels, whose keys [data.files] may give.
std::vector<ident::FurtherFile> level_files(LawScene& scene, const std::vector<std::string>& names);

/// [[joint.friction]]
void read_friction_joints(const scene::Item& item, LawScene& scene);

}  // namespace jointid::laws
