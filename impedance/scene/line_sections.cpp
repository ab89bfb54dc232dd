#include "impedance/scene/line_sections.hpp"

#include "ident/scene/drawn_lines.hpp"
#include "ident/scene/scene_sections.hpp"

namespace jointid::impedance {
namespace {

void refuse_identify(const scene::Item& item, const ident::IdentifySection& identify) {
  const scene::Table table = item.open_table();
  for (const auto& [key, value] : table.members()) {
    if (key != "method" && key != "equations" && key != "variance" && key != "smooth_variance") {
      value.fail("does not apply to lines",
                 "remove " + key + ": [joint] lines has method, equations, variance and smooth_variance");
    }
  }
  if (!identify.automatic && identify.method != ident::Method::likelihood) {
    table.require("method").fail("Z at every line is found by ways, not by method \"" + ident::name(identify.method) + "\"",
                                 "remove method; [joint] way = \"primal\" and others choose closed forms");
  }
}

}  // namespace

LineScene read_sections(const scene::Document& document, const std::filesystem::path& file) {
  const scene::Table& table = document.table();
  LineScene out;
  ident::Scene& scene = out.scene;
  scene.file = file;
  scene.title = document.title();
  scene.data = ident::read_data(table.require("data"), file.parent_path());
  if (const auto frequency = table.find("frequency")) scene.frequency = ident::read_frequency(*frequency);
  if (const auto identify = table.find("identify")) {
    scene.identify.automatic = !identify->open_table().find("method");
    ident::IdentifySection read = ident::read_identify(*identify, scene.joints);
    read.automatic = scene.identify.automatic || read.automatic;
    refuse_identify(*identify, read);
    scene.identify = read;
  }
  if (const auto noise = table.find("noise")) scene.noise = ident::read_noise(*noise);
  ident::read_virtual_points(table, file.parent_path(), ident::all_files(scene.data));
  ident::set_virtual_noise(scene.noise, ident::all_files(scene.data));
  ident::read_drawn_lines(table);
  return out;
}

}  // namespace jointid::impedance
