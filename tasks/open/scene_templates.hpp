#pragma once

#include <string_view>
#include <vector>

namespace jointid::tasks {

/// The text of a scene to be filled in: files that need not be there, DOFs of two nodes, comments that say what each table is for. It is
/// a scene that its reader accepts as it stands.
struct SceneTemplate {
  std::string_view name;  ///< "joint", "coupling", "decoupling", "virtual-points", "friction"
  std::string_view text;
};

/// All of them, the commonest first.
const std::vector<SceneTemplate>& scene_templates();

}  // namespace jointid::tasks
