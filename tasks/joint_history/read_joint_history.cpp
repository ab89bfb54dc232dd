#include <cmath>
#include <numbers>

#include "friction/law/laws.hpp"
#include "friction/path/scaled.hpp"
#include "scene/document.hpp"
#include "scene/text.hpp"
#include "tasks/joint_history/joint_history.hpp"
#include "tasks/response/response_sections.hpp"

namespace jointid::tasks {
namespace {

using friction::JointMesh;

const std::vector<std::string> member_kinds = {"bar", "beam"}, loaded_ends = {"last", "first"}, algorithms = {"A", "B"};
constexpr int most_members = 2000, most_points = 1000000;

std::vector<double> positives(const scene::Item& item) {
  std::vector<double> numbers;
  for (const scene::Item& each : item.list_not_empty()) numbers.push_back(each.positive());
  return numbers;
}

/// `key` as a list of `count`, or `single` for all of them.
std::vector<double> spread(const scene::Table& table, const std::string& key, const std::string& single, std::size_t count) {
  const auto list = table.find(key);
  if (!list) return std::vector<double>(count, table.require(single).positive());
  std::vector<double> numbers = positives(*list);
  if (numbers.size() != count)
    list->fail("has " + std::to_string(numbers.size()) + " values",
               "give one for each of the " + std::to_string(count) + " members");
  return numbers;
}

std::vector<double> member_lengths(const scene::Table& table) {
  if (const auto list = table.find("lengths")) return positives(*list);
  const auto count = static_cast<std::size_t>(table.require("members").whole(1, most_members));
  return std::vector<double>(count, table.require("length").positive() / static_cast<double>(count));
}

/// A law per area over the width at each node; `stiffness` replaces its k node by node.
std::vector<std::shared_ptr<const friction::Element>> interface_of(const scene::Table& table, double width, std::size_t nodes) {
  const std::shared_ptr<const friction::Element> law = read_friction(table);
  if (!law) table.itself().fail("the interface has no law", "give law and parameters, per area: N/m² over m");
  std::vector<std::shared_ptr<const friction::Element>> all(nodes, std::make_shared<friction::Scaled>(law, width));
  const auto list = table.find("stiffness");
  if (!list) return all;
  const std::vector<double> numbers = positives(*list);
  if (numbers.size() != nodes)
    list->fail("has " + std::to_string(numbers.size()) + " values",
               "give one for each of the " + std::to_string(nodes) + " nodes");
  const auto parameters = law->parameters();
  for (std::size_t node = 0; node < nodes; ++node) {
    std::vector<double> values = law->values();
    bool found = false;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i].name != "k") continue;
      values[i] = numbers[node];
      found = true;
    }
    if (!found) list->fail("the law has no parameter k", "leave stiffness out");
    all[node] = std::make_shared<friction::Scaled>(law->with(values), width);
  }
  return all;
}

JointMesh read_mesh(const scene::Item& item) {
  const scene::Table table = item.table({"kind", "youngs_modulus", "width", "length", "members", "lengths", "height", "heights",
                                         "law", "parameters", "parts", "stiffness", "end_spring", "loaded"});
  JointMesh mesh;
  if (const auto kind = table.find("kind"); kind && kind->word(member_kinds) == "beam") mesh.kind = friction::MemberKind::beam;
  const double modulus = table.require("youngs_modulus").positive(), width = table.require("width").positive();
  const std::vector<double> lengths = member_lengths(table), heights = spread(table, "heights", "height", lengths.size());
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const double area = width * heights[i], inertia = area * heights[i] * heights[i] / 12.0;
    mesh.members.push_back({lengths[i], modulus * (mesh.kind == friction::MemberKind::bar ? area : inertia)});
  }
  mesh.interface = interface_of(table, width, lengths.size() + 1);
  if (const auto spring = table.find("end_spring")) mesh.end_spring = spring->not_negative();
  if (const auto loaded = table.find("loaded"); loaded && loaded->word(loaded_ends) == "first") {
    std::ranges::reverse(mesh.members);
    std::ranges::reverse(mesh.interface);
  }
  return mesh;
}

/// [[harmonic, share, phase in degrees], …]
std::vector<NormalLoad> read_normal(const scene::Item& item) {
  std::vector<NormalLoad> parts;
  for (const scene::Item& one : item.list_not_empty()) {
    const std::vector<scene::Item> row = one.list();
    if (row.size() != 3) one.fail("a part of the normal load is [harmonic, share, phase in degrees]");
    parts.push_back({row[0].whole(1, 1000), row[1].number(), row[2].number() * std::numbers::pi / 180.0});
  }
  return parts;
}

void read_sine(const scene::Table& table, JointHistoryScene& scene) {
  scene.amplitude = table.require("amplitude").positive();
  if (const auto cycles = table.find("cycles")) scene.cycles = static_cast<std::size_t>(cycles->whole(1, 1000));
  if (const auto steps = table.find("steps")) scene.steps = static_cast<std::size_t>(steps->whole(4, 100000));
  const auto normal = table.find("normal");
  if (normal) {
    if (scene.mesh) normal->fail("a mesh has one normal load", "remove it");
    scene.normal = read_normal(*normal);
    scene.sliders = 100;  // Masing's rule does not hold
  }
  if (const auto algorithm = table.find("algorithm")) {
    const bool a = algorithm->word(algorithms) == "A";
    if (!a && normal) algorithm->fail("Masing's rule does not hold with a changing normal load", "take \"A\"");
    if (a && scene.mesh) algorithm->fail("a mesh follows Masing paths", "remove it");
    scene.sliders = a ? 100 : 0;
  }
  if (const auto sliders = table.find("sliders")) {
    if (scene.sliders == 0) sliders->fail("only algorithm A has sliders", "give algorithm = \"A\"");
    scene.sliders = static_cast<std::size_t>(sliders->whole(1, 100000));
  }
}

void read_turns(const scene::Item& turns, const scene::Table& table, JointHistoryScene& scene) {
  for (const char* key : {"cycles", "steps", "normal", "algorithm", "sliders"}) {
    if (const auto other = table.find(key)) other->fail("is of a sine", "give amplitude, or remove it");
  }
  for (const scene::Item& turn : turns.list_not_empty()) scene.turns.push_back(turn.number());
  if (const auto points = table.find("points"))
    scene.points = static_cast<std::size_t>(points->whole(1, most_points / static_cast<int>(scene.turns.size())));
}

/// h of which u(h) is asked.
std::vector<double> read_shares(const scene::Item& item, const JointHistoryScene& scene) {
  if (scene.mesh) item.fail("a mesh has no u(h): each node slips by its own law", "remove it");
  std::vector<double> shares;
  for (const scene::Item& each : item.list_not_empty()) {
    shares.push_back(each.not_negative());
    if (!(shares.back() < 1.0)) each.fail("is no share below 1", "u(1) is where all has slipped: take 0.999");
  }
  return shares;
}

void read_history(const scene::Item& item, JointHistoryScene& scene) {
  const scene::Table table =
      item.table({"displacements", "forces", "points", "amplitude", "cycles", "steps", "normal", "algorithm", "sliders",
                  "shares"});
  const auto displacements = table.find("displacements"), forces = table.find("forces"), amplitude = table.find("amplitude");
  if (int(displacements.has_value()) + int(forces.has_value()) + int(amplitude.has_value()) != 1)
    item.fail("give one of displacements, forces and amplitude");
  scene.by_force = forces.has_value();
  if (!amplitude) return read_turns(forces ? *forces : *displacements, table, scene);
  if (const auto points = table.find("points")) points->fail("a sine has steps", "give steps");
  read_sine(table, scene);
}

}  // namespace

JointHistoryScene parse_joint_history(const std::string& text, const std::filesystem::path& file) {
  const scene::Document document(text, file, {"joint", "mesh", "history"});
  const scene::Table& table = document.table();
  const auto joint = table.find("joint"), mesh = table.find("mesh");
  JointHistoryScene scene;
  scene.title = document.title();
  if (joint.has_value() == mesh.has_value())
    document.root().fail(joint ? "there are both [joint] and [mesh]" : "there is neither [joint] nor [mesh]", "give one of them");
  if (joint) {
    scene.law = read_friction(joint->table({"law", "parameters", "parts"}));
    if (!scene.law) joint->fail("there is no law", "give law and parameters");
  } else {
    scene.mesh = mesh->here([&] { return read_mesh(*mesh); });
  }
  const scene::Item history = table.require("history");
  read_history(history, scene);
  if (const auto shares = history.open_table().find("shares")) scene.shares = read_shares(*shares, scene);
  return scene;
}

JointHistoryScene read_joint_history(const std::filesystem::path& file) {
  return parse_joint_history(scene::read_text(file), file);
}

}  // namespace jointid::tasks
