#include "laws/scene/law_scene.hpp"

namespace jointid::laws {

std::vector<std::string> level_names(const LawScene& scene) {
  std::vector<std::string> names;
  for (const ForceLevel& level : scene.levels) names.push_back(level.name);
  return names;
}

std::vector<ident::NamedFile> files_of(const LawScene& scene) {
  std::vector<ident::NamedFile> files;
  if (!scene.file.empty()) files.push_back({scene.file, "the scene"});
  const auto add = [&](const ident::DataFile& file, const char* place) {
    files.push_back({file.path, place});
    for (const ident::DataFile& repeat : file.repeats) files.push_back({repeat.path, place});
  };
  for (const ident::DataFile& part : scene.parts) add(part, "[data] parts");
  for (const ForceLevel& level : scene.levels) {
    if (level.planned) continue;
    if (level.records) {
      for (const ident::Path& file : level.records->files) files.push_back({file, "[[data.levels]] records"});
      continue;
    }
    for (const HarmonicFiles& each : level.harmonics) {
      add(each.responses, "[[data.levels]] responses");
      if (each.forces) add(*each.forces, "[[data.levels]] forces");
    }
  }
  return files;
}

}  // namespace jointid::laws
