#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace jointid::problems {

/// A finite-element joint of thesis §2.16.2: a steel bar of 10 mm × 10 mm, or that of Table 2.8, on an interface, loaded at its
/// last node.
struct MeshJoint {
  std::string name;  ///< "mesh-two", "mesh-three-A" …
  std::string description;
  std::string mesh;           ///< the scene's [mesh] without its title, TOML
  double limit = 0.0;         ///< N, of the whole interface
  double displacement = 0.0;  ///< m, of the loaded end at 0.9 of the limit, by an independent program
};

const std::vector<MeshJoint>& list_mesh_joints();

/// The one of that name, or null.
const MeshJoint* find_mesh_joint(const std::string& name);

/// Writes NAME.toml, a scene of `jointid loading-curve` that loads to 0.9 of the limit and back, and truth.json; the path of the
/// scene.
std::filesystem::path write(const MeshJoint& problem, const std::filesystem::path& directory);

}  // namespace jointid::problems
