#include "ident/scene/equivalent_scene.hpp"

#include "ident/scene/scene_sections.hpp"
#include "scene/document.hpp"
#include "scene/text.hpp"

namespace jointid::ident {
namespace {

const std::vector<std::string> weighting_words = {"none", "relative"};

/// `names` gets the files as written.
DisplacementLevel read_level(const scene::Item& item, const Path& folder, std::vector<std::string>& names) {
  const scene::Table table = item.table({"assembly", "displacement"});
  names.push_back(table.require("assembly").text_not_empty());
  DisplacementLevel level;  // not in one list: GCC 12 destroys a nested list twice when what follows it throws
  level.assembly.path = folder / names.back();
  level.displacement = table.require("displacement").positive();
  return level;
}

/// The files of the levels and of the rigid joint, with their names.
std::vector<FurtherFile> assemblies(EquivalentScene& scene, const std::vector<std::string>& names) {
  std::vector<FurtherFile> files;
  for (std::size_t i = 0; i < scene.levels.size(); ++i) files.push_back({names[i], &scene.levels[i].assembly});
  if (scene.rigid) files.push_back({names.back(), &*scene.rigid});
  return files;
}

/// Returns the names of the assemblies, that of the rigid joint last.
std::vector<std::string> read_equivalent(const scene::Item& item, const Path& folder, EquivalentScene& scene) {
  std::vector<std::string> names;
  const scene::Table table = item.table({"dofs", "levels", "rigid", "real", "weighting"});
  const scene::Item dofs = table.require("dofs");
  const std::vector<frf::Dof> ends = dofs.dofs();
  if (ends.size() != 2) dofs.fail("a joint with one stiffness and one damping has two ends", "name two DOFs");
  scene.dofs = {ends[0], ends[1]};
  for (const scene::Item& level : table.require("levels").list_not_empty()) scene.levels.push_back(read_level(level, folder, names));
  if (const auto rigid = table.find("rigid")) {
    names.push_back(rigid->text_not_empty());
    scene.rigid = DataFile{folder / names.back(), {}};
  }
  if (const auto real = table.find("real")) scene.real = real->boolean();
  if (const auto weighting = table.find("weighting")) scene.relative = weighting->word(weighting_words) == "relative";
  return names;
}

}  // namespace

EquivalentScene parse_equivalent_scene(const std::string& text, const Path& file) {
  const scene::Document document(text, file, {"data", "frequency", "equivalent"});
  const scene::Table& table = document.table();
  EquivalentScene scene;
  scene.file = file;
  scene.title = document.title();
  const scene::Item data_item = table.require("data");
  const std::vector<std::string> assembly_names = read_equivalent(table.require("equivalent"), file.parent_path(), scene);
  std::vector<std::string> part_names;
  const DataSection data = read_parts_section(data_item, file.parent_path(), part_names, assemblies(scene, assembly_names));
  scene.parts = data.substructures;
  scene.reciprocity = data.reciprocity;
  if (const auto frequency = table.find("frequency")) {
    scene.frequency = read_frequency(*frequency);
    if (scene.frequency.exclude_resonances)
      frequency->fail("the lines of an equivalent joint lie at a resonance", "remove exclude_resonances");
  }
  return scene;
}

EquivalentScene read_equivalent_scene(const Path& file) { return parse_equivalent_scene(scene::read_text(file), file); }

}  // namespace jointid::ident
