#include "laws/scene/read_law_scene.hpp"

#include "laws/scene/sections.hpp"
#include "response/fourier/harmonics.hpp"
#include "scene/document.hpp"
#include "scene/text.hpp"

namespace jointid::laws {
namespace {

void read_errors(const scene::Item& item, LawScene& scene) {
  const scene::Table table = item.table({"relative", "floor", "force"});
  PhasorErrors errors;
  const auto relative = table.find("relative"), floor = table.find("floor"), force = table.find("force");
  if (relative) errors.relative = relative->not_negative();
  if (floor) errors.floor = floor->not_negative();
  if (force) errors.force = force->not_negative();
  if (!errors.of_responses() && !(errors.force > 0.0))
    item.fail("no phasor has an error",
              "give relative (a share of each phasor), floor (m) or force (a share of each force) above 0");
  scene.errors = errors;
}

void read_model(const scene::Item& item, LawScene& scene) {
  const scene::Table table = item.table({"responses", "harmonics"});
  if (const auto responses = table.find("responses")) scene.responses = responses->dofs();
  const auto harmonics = table.find("harmonics");
  if (!harmonics) return;
  for (const scene::Item& number : harmonics->list_not_empty()) scene.harmonics.push_back(number.whole(0, 200));
  harmonics->here([&] { return response::Harmonics(scene.harmonics); });
}

/// Which lines of a file that holds several harmonics are those of the first, only the range tells.
void require_range(const scene::Table& table, const LawScene& scene) {
  for (const ForceLevel& level : scene.levels) {
    if (level.planned || level.records || level.harmonics.size() == 1 ||
        level.harmonics[0].responses.path != level.harmonics[1].responses.path)
      continue;
    if (scene.frequency.range_hz) return;
    table.itself().fail(level.name + ": one file holds several harmonics, and nothing names the lines of the first",
                        "give [frequency] range, the frequencies of the force");
  }
}

}  // namespace

LawScene parse_law_scene(const std::string& text, const ident::Path& file) {
  const scene::Document document(text, file, {"data", "frequency", "joint", "errors", "identify"});
  const scene::Table& table = document.table();
  LawScene scene;
  scene.file = file;
  scene.title = document.title();
  const scene::Item data = table.require("data");
  std::vector<std::string> level_names, part_names;
  read_levels(data.open_table().require("levels"), file.parent_path(), scene, level_names);
  const ident::DataSection parts =
      ident::read_parts_section(data, file.parent_path(), part_names, level_files(scene, level_names), {"levels"});
  scene.parts = parts.substructures;
  scene.reciprocity = parts.reciprocity;
  read_friction_joints(table.require("joint").table({"friction"}).require("friction"), scene);
  if (const auto frequency = table.find("frequency")) {
    scene.frequency = ident::read_frequency(*frequency);
    if (scene.frequency.exclude_resonances)
      frequency->fail("friction shows at resonances", "remove exclude_resonances; exclude takes ranges");
  }
  require_range(table, scene);
  if (const auto errors = table.find("errors")) read_errors(*errors, scene);
  if (const auto identify = table.find("identify")) read_model(*identify, scene);
  return scene;
}

LawScene read_law_scene(const ident::Path& file) { return parse_law_scene(scene::read_text(file), file); }

}  // namespace jointid::laws
