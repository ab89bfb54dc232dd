#include "tasks/response/response_sections.hpp"
#include "tasks/response/scene_values.hpp"

namespace jointid::tasks {

SceneDof read_dof(const scene::Item& item, const ResponseScene& scene) {
  SceneDof found;
  if (coordinates(scene) > 0) {
    const int number = item.whole(1, static_cast<int>(coordinates(scene)));
    found.coordinate = number - 1;
    found.name = std::to_string(number);
  } else {
    found.dof = item.dof();
    found.name = found.dof.name();
  }
  return found;
}

namespace {

/// Standard deviations by parameter name; 0 for those that are not named.
std::vector<double> read_deviations(const scene::Item& item, const response::Joint& joint) {
  if (!joint.friction) item.fail("there are deviations and no law", "name the law");
  std::vector<std::string> names;
  for (const friction::Parameter& parameter : joint.friction->parameters()) names.push_back(parameter.name);
  const scene::Table table = item.table(names);
  std::vector<double> values;
  for (const std::string& name : names) {
    const auto value = table.find(name);
    values.push_back(value ? value->not_negative() : 0.0);
  }
  return values;
}

}  // namespace

std::size_t read_joint_place(const scene::Item& item, const ResponseScene& scene) {
  if (!item.is_text()) return static_cast<std::size_t>(item.whole(1, static_cast<int>(scene.joints.size()))) - 1;
  std::vector<std::string> names;
  for (const SceneJoint& joint : scene.joints) names.push_back(joint.joint.name);
  return static_cast<std::size_t>(std::ranges::find(names, item.word(names)) - names.begin());
}

SceneJoint read_joint(const scene::Item& item, const ResponseScene& scene, std::size_t number) {
  const scene::Table table =
      item.table({"name", "dofs", "law", "parameters", "parts", "deviations", "stiffness", "damping", "cubic"});
  SceneJoint joint;
  const scene::Item ends = table.require("dofs");
  const std::vector<scene::Item> list = ends.list_not_empty();
  if (list.size() > 2) ends.fail("a joint has one end or two", "give each relative coordinate a joint of its own");
  joint.positive = read_dof(list[0], scene);
  if (list.size() == 2) joint.negative = read_dof(list[1], scene);
  if (joint.negative && joint.negative->name == joint.positive.name) ends.fail("both ends are " + joint.positive.name);
  joint.joint.name = joint.positive.name + "–" + (joint.negative ? joint.negative->name : "ground");
  if (const auto name = table.find("name")) joint.joint.name = name->text_not_empty();
  joint.joint.friction = read_friction(table);
  if (const auto deviations = table.find("deviations")) joint.deviations = read_deviations(*deviations, joint.joint);
  if (const auto stiffness = table.find("stiffness")) joint.joint.stiffness = stiffness->number();
  if (const auto damping = table.find("damping")) joint.joint.damping = damping->not_negative();
  if (const auto cubic = table.find("cubic")) joint.joint.cubic = cubic->number();
  if (!joint.joint.friction && joint.joint.stiffness == 0.0 && joint.joint.damping == 0.0 && joint.joint.cubic == 0.0) {
    item.fail("joint " + std::to_string(number) + " has no force", "give it law and parameters, stiffness, damping or cubic");
  }
  return joint;
}

}  // namespace jointid::tasks
