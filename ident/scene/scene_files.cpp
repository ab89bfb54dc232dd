#include "ident/scene/scene_files.hpp"

#include "models/model_file.hpp"

namespace jointid::ident {
namespace {

std::vector<NamedFile> scene_alone(const Path& scene) {
  if (scene.empty()) return {};
  return {{scene, "the scene"}};
}

void add_file(const DataFile& file, const std::string& place, std::vector<NamedFile>& to) {
  to.push_back({file.path, place});
  if (models::is_model_file(file.path)) {
    for (const Path& named : models::files_of_model(file.path)) to.push_back({named, place + ", " + file.path.filename().string()});
  }
  if (file.nodes) to.push_back({*file.nodes, place + ", nodes"});
  if (file.model) add_file({.path = *file.model, .options = {}}, place + ", model", to);
  for (const DataFile& run : file.repeats) add_file(run, place, to);
}

void add_files(const std::vector<DataFile>& files, const std::string& place, std::vector<NamedFile>& to) {
  for (const DataFile& file : files) add_file(file, place, to);
}

}  // namespace

std::vector<NamedFile> files_of(const Scene& scene) {
  std::vector<NamedFile> all = scene_alone(scene.file);
  add_files(scene.data.substructures, "[data] substructures", all);
  add_files(scene.data.assembly, "[data] assembly", all);
  return all;
}

std::vector<NamedFile> files_of(const CoupleScene& scene) {
  std::vector<NamedFile> all = scene_alone(scene.file);
  add_files(scene.parts, "[data] parts", all);
  for (const IdentifiedJoint& joint : scene.identified) all.push_back({joint.scene, "[[couple.joint]] identified"});
  return all;
}

std::vector<NamedFile> files_of(const EquivalentScene& scene) {
  std::vector<NamedFile> all = scene_alone(scene.file);
  add_files(scene.parts, "[data] parts", all);
  for (const DisplacementLevel& level : scene.levels) add_file(level.assembly, "[equivalent] levels", all);
  if (scene.rigid) add_file(*scene.rigid, "[equivalent] rigid", all);
  return all;
}

}  // namespace jointid::ident
