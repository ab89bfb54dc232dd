#include <algorithm>

#include "tasks/response/response_sections.hpp"

namespace jointid::tasks {
namespace {

/// Numbers or names of [[joints]], each with a law; without the key all that have one.
std::vector<std::size_t> read_clamped_joints(const scene::Item& section, const scene::Table& table, const ResponseScene& scene) {
  std::vector<std::size_t> joints;
  const auto has_law = [&](std::size_t j) { return scene.joints[j].joint.friction != nullptr; };
  if (const auto list = table.find("joints")) {
    for (const scene::Item& number : list->list_not_empty()) {
      const std::size_t j = read_joint_place(number, scene);
      const std::string name = "joint " + std::to_string(j + 1);
      if (!has_law(j)) number.fail(name + " has no friction law: no load changes it", "name a joint with a law");
      if (std::ranges::find(joints, j) != joints.end()) number.fail(name + " is named twice", "remove one");
      joints.push_back(j);
    }
    return joints;
  }
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    if (has_law(j)) joints.push_back(j);
  }
  if (joints.empty()) section.fail("no joint has a friction law", "give a joint law and parameters, or remove [clamping]");
  return joints;
}

}  // namespace

SceneClamping read_clamping(const scene::Item& item, const ResponseScene& scene) {
  const scene::Table table = item.table({"joints", "range", "points", "nominal"});
  SceneClamping clamping;
  const scene::Item range = table.require("range");
  clamping.range = range.interval();
  if (clamping.range[0] <= 0.0) range.fail("a load of 0 clamps nothing", "begin above it, as [0.01, 100]");
  if (const auto points = table.find("points")) clamping.points = static_cast<std::size_t>(points->whole(3, 1000));
  if (const auto nominal = table.find("nominal")) clamping.nominal = nominal->positive();
  clamping.joints = read_clamped_joints(item, table, scene);
  return clamping;
}

}  // namespace jointid::tasks
