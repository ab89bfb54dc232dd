#include "impedance/decouple/decouple_scene.hpp"

#include "impedance/scene/line_sections.hpp"
#include "scene/text.hpp"

namespace jointid::impedance {
namespace {

const std::vector<std::string> decouple_words = {"likelihood", "standard", "extended", "both"};

}  // namespace

std::string name(DecoupleWay way) { return decouple_words[static_cast<std::size_t>(way)]; }

DecoupleScene parse_decouple_scene(const std::string& text, const std::filesystem::path& file) {
  const scene::Document document(text, file, {"data", "frequency", "decouple", "nodes", "geometry", "identify", "noise", "virtual_points"});
  DecoupleScene out;
  out.lines = read_sections(document, file);
  const scene::Item item = document.table().require("decouple");
  const scene::Table table = item.table({"interface", "way"});
  out.interface = table.require("interface").dofs();
  if (const auto way = table.find("way")) out.ways = read_words<DecoupleWay>(*way, decouple_words, "way");
  out.lines.scene.joints.emplace_back();
  out.lines.scene.joints.back().dofs = out.interface;
  item.here([&] { set_structure(out.lines); });
  return out;
}

DecoupleScene read_decouple_scene(const std::filesystem::path& file) {
  return parse_decouple_scene(scene::read_text(file), file);
}

}  // namespace jointid::impedance
