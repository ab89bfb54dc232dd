#include "ident/scene/readable_scene.hpp"

#include "ident/scene/scene_sections.hpp"

namespace jointid::ident {
namespace {

using restrictions::JointSpec;

/// The DOFs among the items of a list, each coordinate once.
std::vector<frf::Dof> readable_dofs(const scene::Item& list) {
  std::vector<frf::Dof> dofs;
  for (const scene::Item& item : list.list()) {
    if_readable([&] {
      const frf::Dof dof = item.dof();
      if (!frf::has(dofs, dof)) dofs.push_back(dof);
    });
  }
  return dofs;
}

/// The joint with its DOFs alone.
void add_joint(const scene::Item& item, std::vector<JointSpec>& joints) {
  if_readable([&] {
    const auto dofs = item.open_table().find("dofs");
    if (!dofs) return;
    JointSpec joint;
    joint.dofs = readable_dofs(*dofs);
    joints.push_back(std::move(joint));
  });
}

std::vector<JointSpec> readable_joints(const scene::Table& table) {
  std::vector<JointSpec> joints;
  if (if_readable([&] { joints = read_joints(table); })) return joints;
  joints.clear();
  if (const auto joint = table.find("joint")) add_joint(*joint, joints);
  if (const auto list = table.find("joints"); list && list->is_list()) {
    for (const scene::Item& item : list->list()) add_joint(item, joints);
  }
  return joints;
}

}  // namespace

std::optional<Scene> parse_readable(const std::string& text, const Path& file) {
  scene::Value value;
  if (!if_readable([&] { value = scene::parse_toml(text, file); })) return std::nullopt;
  const std::string name = file.string();
  const scene::Item root(value, name, {}, {});
  const scene::Table table = root.open_table();
  const auto data = table.find("data");
  if (!data || !data->is_table()) return std::nullopt;
  Scene scene;
  scene.file = file;
  scene.data = readable_data(*data, file.parent_path());
  if (const auto frequency = table.find("frequency")) if_readable([&] { scene.frequency = read_frequency(*frequency); });
  scene.joints = readable_joints(table);
  if_readable([&] { read_virtual_points(table, file.parent_path(), all_files(scene.data)); });
  return scene;
}

}  // namespace jointid::ident
