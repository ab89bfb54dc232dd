#include "ident/scene/couple_scene.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "ident/scene/drawn_lines.hpp"
#include "ident/scene/scene_sections.hpp"
#include "scene/document.hpp"
#include "scene/text.hpp"

namespace jointid::ident {
namespace {

using coupling::PlacedDof;

const std::vector<std::string> methods = {"gic", "rc", "grc", "pcc", "mtc"};
const std::vector<std::string> thresholds = {"none", "fixed", "noise", "picard", "alpha", "auto"};

PlacedDof read_dof(const scene::Item& item) {
  return item.here([&] { return coupling::parse_placed_dof(item.text()); });
}

std::vector<PlacedDof> read_dofs(const scene::Item& list) {
  std::vector<PlacedDof> out;
  for (const scene::Item& item : list.list_not_empty()) out.push_back(read_dof(item));
  return out;
}

std::vector<std::vector<PlacedDof>> read_join(const scene::Item& list) {
  std::vector<std::vector<PlacedDof>> out;
  for (const scene::Item& item : list.list_not_empty()) {
    out.push_back(read_dofs(item));
    if (out.back().size() < 2) item.fail("one DOF alone joins nothing", "name two or more that are one, or use ground");
  }
  return out;
}

std::vector<double> read_matrix(const scene::Table& joint, restrictions::Kind kind, std::size_t size) {
  const auto table = joint.find(restrictions::key(kind));
  if (!table) return {};
  std::vector<double> out;
  for (const auto& row : table->table({"matrix"}).require("matrix").square_matrix(size)) out.insert(out.end(), row.begin(), row.end());
  return out;
}

coupling::KnownJoint read_known_joint(const scene::Item& item) {
  std::vector<std::string> keys = kind_keys();
  keys.insert(keys.begin(), "dofs");
  const scene::Table table = item.table(keys);
  coupling::KnownJoint joint;
  joint.dofs = read_dofs(table.require("dofs"));
  joint.stiffness = read_matrix(table, restrictions::Kind::stiffness, joint.dofs.size());
  joint.mass = read_matrix(table, restrictions::Kind::mass, joint.dofs.size());
  joint.viscous_damping = read_matrix(table, restrictions::Kind::viscous_damping, joint.dofs.size());
  joint.hysteretic_damping = read_matrix(table, restrictions::Kind::hysteretic_damping, joint.dofs.size());
  if (table.members().size() == 1) item.fail("the joint has no matrix", "give it one of " + one_of(kind_keys()) + ", all numbers known");
  return joint;
}

bool is_identified(const scene::Item& item) { return item.is_table() && item.open_table().find("identified").has_value(); }

IdentifiedJoint read_identified_joint(const scene::Item& item, const Path& folder) {
  const scene::Table table = item.table({"identified", "dofs"});
  IdentifiedJoint joint{folder / table.require("identified").text(), {}};
  if (const auto dofs = table.find("dofs")) joint.dofs = read_dofs(*dofs);
  return joint;
}

void read_options(const scene::Table& table, CoupleScene& scene) {
  coupling::Options& options = scene.options;
  if (const auto method = table.find("method")) options.method = coupling::parse_method(method->word(methods));
  if (const auto threshold = table.find("threshold")) {
    const std::string word = threshold->word(thresholds);
    scene.find_dependent = word == "auto";
    const auto at = std::ranges::find(thresholds, word) - thresholds.begin();
    if (!scene.find_dependent) options.threshold = static_cast<coupling::Threshold>(at);
    threshold->here([&] { coupling::validate(options, {}); });
  }
  const auto number_of = [&](const char* key, coupling::Threshold threshold, double& to) {
    const auto item = table.find(key);
    if (!item) return;
    if (options.threshold != threshold)
      item->fail("it is given, but the threshold is not \"" + coupling::name(threshold) + "\"", "remove it, or set threshold");
    to = item->number();
    item->here([&] { coupling::validate(options, {}); });
  };
  number_of("epsilon", coupling::Threshold::fixed, options.epsilon);
  number_of("alpha", coupling::Threshold::alpha, options.alpha);
  if (const auto uncertainty = table.find("uncertainty")) options.uncertainty = uncertainty->boolean();
}

void read_couple(const scene::Item& item, const Path& folder, CoupleScene& scene) {
  const scene::Table table =
      item.table({"join", "ground", "remove", "keep", "joint", "method", "threshold", "epsilon", "alpha", "uncertainty"});
  coupling::Assembly& assembly = scene.assembly;
  if (const auto join = table.find("join")) assembly.join = read_join(*join);
  if (const auto ground = table.find("ground")) assembly.ground = read_dofs(*ground);
  if (const auto keep = table.find("keep")) assembly.keep = read_dofs(*keep);
  if (const auto remove = table.find("remove")) {
    for (const scene::Item& part : remove->list_not_empty()) assembly.remove.push_back(part.word(scene.names));
  }
  if (const auto joint = table.find("joint")) {
    const std::vector<scene::Item> joints = joint->is_list() ? joint->list_not_empty() : std::vector<scene::Item>{*joint};
    for (const scene::Item& one : joints) {
      is_identified(one) ? scene.identified.push_back(read_identified_joint(one, folder))
                         : assembly.joints.push_back(read_known_joint(one));
    }
  }
  if (assembly.join.empty() && assembly.ground.empty() && assembly.joints.empty() && scene.identified.empty()) {
    item.fail("nothing is coupled", "give join, ground or [[couple.joint]]");
  }
  read_options(table, scene);
}

void read_parts(const scene::Table& table, const Path& folder, CoupleScene& scene) {
  DataSection data = read_parts_section(table.require("data"), folder, scene.names);
  read_virtual_points(table, folder, all_files(data));
  scene.parts = data.substructures;
  scene.reciprocity = data.reciprocity;
}

void read_noise_law(const scene::Item& item, coupling::Options& options) {
  const NoiseSection noise = read_noise(item);
  if (noise.model == "modal") item.fail("model \"modal\" has no law for a single FRF", "use another model, or leave [noise] out");
  if (noise.frf_model.floor > 0.0) item.fail("coupling has no use for a floor", "remove floor");
  options.noise = noise.frf_model;
}

}  // namespace

CoupleScene parse_couple_scene(const std::string& text, const Path& file) {
  const scene::Document document(text, file, {"data", "frequency", "couple", "noise", "nodes", "geometry", "virtual_points"});
  const scene::Table& table = document.table();
  CoupleScene scene;
  scene.file = file;
  scene.title = document.title();
  read_parts(table, file.parent_path(), scene);
  if (const auto frequency = table.find("frequency")) {
    scene.frequency = read_frequency(*frequency);
    if (scene.frequency.exclude_resonances) frequency->fail("coupling leaves out no resonances", "remove exclude_resonances");
  }
  read_couple(table.require("couple"), file.parent_path(), scene);
  if (const auto noise = table.find("noise")) read_noise_law(*noise, scene.options);
  read_drawn_lines(table);
  return scene;
}

CoupleScene read_couple_scene(const Path& file) { return parse_couple_scene(scene::read_text(file), file); }

}  // namespace jointid::ident
