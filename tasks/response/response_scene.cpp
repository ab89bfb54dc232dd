#include "tasks/response/response_scene.hpp"

namespace jointid::tasks {

Eigen::Index coordinates(const ResponseScene& scene) {
  return scene.structure ? scene.structure->mass.rows() : scene.sparse ? scene.sparse->mass.rows() : 0;
}

bool marches(const ResponseScene& scene) {
  return scene.modes.has_value() || (scene.structure && coordinates(scene) <= most_full);
}

std::vector<ident::NamedFile> files_of(const ResponseScene& scene) {
  std::vector<ident::NamedFile> files = {{scene.file, "the scene"}};
  for (const ident::DataFile& part : scene.parts) {
    files.push_back({part.path, "[data] parts"});
    for (const ident::DataFile& repeat : part.repeats) files.push_back({repeat.path, "[data] parts"});
  }
  if (scene.transient) {
    for (const SceneRecord& record : scene.transient->records) files.push_back(record.file);
  }
  files.insert(files.end(), scene.matrix_files.begin(), scene.matrix_files.end());
  return files;
}

}  // namespace jointid::tasks
