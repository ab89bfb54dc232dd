#include "ident/equivalent_scene.hpp"

#include "ident/scene_sections.hpp"
#include "ident/scene_text.hpp"

namespace jointid::ident {
namespace {

const std::vector<std::string> weightings = {"none", "relative"};

DisplacementLevel read_level(const SceneItem& item, const Path& folder) {
  const SceneTable table = item.table({"assembly", "displacement"});
  return {{folder / table.require("assembly").text_not_empty(), {}}, table.require("displacement").positive()};
}

void read_equivalent(const SceneItem& item, const Path& folder, EquivalentScene& scene) {
  const SceneTable table = item.table({"dofs", "levels", "rigid", "real", "weighting"});
  const SceneItem dofs = table.require("dofs");
  const std::vector<frf::Dof> ends = dofs.dofs();
  if (ends.size() != 2) dofs.fail("a joint with one stiffness and one damping has two ends", "name two DOFs");
  scene.dofs = {ends[0], ends[1]};
  for (const SceneItem& level : table.require("levels").list_not_empty()) scene.levels.push_back(read_level(level, folder));
  if (const auto rigid = table.find("rigid")) scene.rigid = DataFile{folder / rigid->text_not_empty(), {}};
  if (const auto real = table.find("real")) scene.real = real->boolean();
  if (const auto weighting = table.find("weighting")) scene.relative = weighting->word(weightings) == "relative";
}

}  // namespace

EquivalentScene parse_equivalent_scene(const std::string& text, const Path& file) {
  const Value document = parse_toml(text, file);
  const std::string file_name = file.string();
  const SceneItem root(document, file_name, {}, {});
  const SceneTable table = root.table({"title", "data", "frequency", "equivalent"});
  EquivalentScene scene;
  scene.file = file;
  if (const auto title = table.find("title")) scene.title = title->text();
  std::vector<std::string> names;
  const DataSection data = read_parts_section(table.require("data"), file.parent_path(), names);
  scene.parts = data.substructures;
  scene.reciprocity = data.reciprocity;
  if (const auto frequency = table.find("frequency")) {
    scene.frequency = read_frequency(*frequency);
    if (scene.frequency.exclude_resonances) frequency->fail("the lines of an equivalent joint lie at a resonance", "remove exclude_resonances");
  }
  read_equivalent(table.require("equivalent"), file.parent_path(), scene);
  return scene;
}

EquivalentScene read_equivalent_scene(const Path& file) { return parse_equivalent_scene(read_text(file), file); }

}  // namespace jointid::ident
