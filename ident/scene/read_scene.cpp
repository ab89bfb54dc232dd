#include "ident/scene/read_scene.hpp"

#include "ident/scene/drawn_lines.hpp"
#include "ident/scene/reduce_joints.hpp"
#include "ident/scene/scene_sections.hpp"
#include "scene/document.hpp"
#include "scene/text.hpp"
#include "ident/scene/scene_failure.hpp"
#include "ident/scene/variance_origin.hpp"

namespace jointid::ident {

Scene parse_scene(const std::string& text, const Path& file) {
  const scene::Document document(
      text, file, {"data", "frequency", "joint", "joints", "nodes", "geometry", "identify", "noise", "truth", "virtual_points"});
  const scene::Table& table = document.table();
  Scene scene;
  scene.file = file;
  scene.title = document.title();
  scene.data = read_data(table.require("data"), file.parent_path());
  if (const auto frequency = table.find("frequency")) scene.frequency = read_frequency(*frequency);
  scene.joints = read_joints(table);
  scene.identify.automatic = scene.identify.any_weighting = true;
  if (const auto identify = table.find("identify")) {
    const auto loose = identify->is_table() ? identify->open_table().find("loose") : std::nullopt;
    if (loose && loose->boolean()) make_nominal(*loose, scene.joints);
  }
  if (const auto identify = table.find("identify")) scene.identify = read_identify(*identify, scene.joints);
  if (const auto noise = table.find("noise")) scene.noise = read_noise(*noise);
  read_virtual_points(table, file.parent_path(), all_files(scene.data));
  read_drawn_lines(table);  // of pictures: they are only checked
  set_virtual_noise(scene.noise, all_files(scene.data));
  if (scene.identify.variance == VarianceChoice::noise && table.find("virtual_points")) {
    fail(scene, "[identify] variance", "\"noise\" is the law of measured FRFs, not of those of virtual points",
         "leave it out: [noise] is carried to them from FRFs whose files have no variances");
  }
  if (scene.identify.variance == VarianceChoice::noise) require_noise_law(scene);
  if (const auto truth = table.find("truth")) scene.truth = read_matrices(*truth, joint_size(scene.joints));
  scene.couple_first.pairs = read_couple_first(table);
  if (!scene.couple_first.pairs.empty()) document.root().here([&] { reduce_joints(scene); });
  return scene;
}

Scene read_scene(const Path& file) { return parse_scene(scene::read_text(file), file); }

}  // namespace jointid::ident
