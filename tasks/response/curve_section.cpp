#include <algorithm>

#include "tasks/response/response_sections.hpp"
#include "tasks/response/scene_values.hpp"

namespace jointid::tasks {
namespace {

std::size_t read_joint_number(const scene::Table& table, const ResponseScene& scene) {
  const auto joint = table.find("joint");
  if (!joint) return 0;
  return static_cast<std::size_t>(joint->whole(1, static_cast<int>(scene.joints.size()))) - 1;
}

std::array<double, 2> read_ends(const scene::Item& item) {
  const std::vector<scene::Item> ends = item.list();
  if (ends.size() != 2) item.fail("a range is [from, to]");
  const std::array<double, 2> range = {ends[0].number(), ends[1].number()};
  if (range[0] == range[1]) item.fail("both ends are " + scene::number_text(range[0]));
  return range;
}

response::JointParameter find_parameter(const scene::Item& along, const scene::Table& table, const ResponseScene& scene) {
  const std::size_t joint = read_joint_number(table, scene);
  const std::vector<std::string> names = scene.joints[joint].joint.parameter_names();
  const std::string name = along.word(names);
  return {joint, static_cast<std::size_t>(std::ranges::find(names, name) - names.begin())};
}

/// Both ends must be values that the law can have.
void check_ends(const scene::Item& item, const SceneCurve& curve, const ResponseScene& scene) {
  const response::Joint& joint = scene.joints[curve.parameter->joint].joint;
  for (const double end : curve.range) {
    std::vector<double> values = joint.values();
    values[curve.parameter->parameter] = end;
    item.here([&] { (void)joint.with(values); });
  }
}

}  // namespace

void require_full(const scene::Item& item, const ResponseScene& scene) {
  if (scene.structure) return;
  if (scene.sparse) {
    item.fail("the structure has " + std::to_string(coordinates(scene)) + " coordinates, full matrices at most " +
                  std::to_string(most_full),
              "condense it first");
  }
  item.fail("needs mass, damping and stiffness", "give [structure], or remove it");
}

void require_marching(const scene::Item& item, const ResponseScene& scene) {
  if (marches(scene)) return;
  if (coordinates(scene) > 0) {
    item.fail("the structure has " + std::to_string(coordinates(scene)) + " coordinates, marching in time takes at most " +
                  std::to_string(most_full),
              "give [structure] modes, on which it marches");
  }
  require_full(item, scene);
}

SceneCurve read_curve(const scene::Item& item, const ResponseScene& scene) {
  const scene::Table table = item.table({"along", "joint", "range", "frequency", "force"});
  SceneCurve curve;
  const scene::Item along = table.require("along"), range = table.require("range");
  curve.along = along.text_not_empty();
  curve.range = read_ends(range);
  curve.frequency_hz = table.require("frequency").positive();
  const auto force = table.find("force");
  if (curve.along == "force") {
    if (force) force->fail("the curve is along the force", "remove it: range gives from where to where");
    if (const auto joint = table.find("joint")) joint->fail("the curve is along the force", "remove it");
    if (std::min(curve.range[0], curve.range[1]) <= 0.0) range.fail("forces are above 0");
    return curve;
  }
  curve.parameter = find_parameter(along, table, scene);
  check_ends(range, curve, scene);
  curve.force = force ? force->positive() : scene.levels.front();
  return curve;
}

SceneEquivalent read_equivalent(const scene::Item& item, const ResponseScene& scene) {
  const scene::Table table = item.table({"amplitudes", "mode", "joint"});
  SceneEquivalent equivalent;
  for (const scene::Item& amplitude : table.require("amplitudes").list_not_empty()) {
    equivalent.amplitudes.push_back(amplitude.positive());
  }
  equivalent.joint = read_joint_number(table, scene);
  if (const auto mode = table.find("mode")) {
    require_full(*mode, scene);
    equivalent.mode = mode->whole(1, static_cast<int>(scene.structure->mass.rows())) - 1;
  }
  return equivalent;
}

}  // namespace jointid::tasks
