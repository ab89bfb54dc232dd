#include <charconv>

#include "base/text.hpp"
#include "ident/scene/scene_matrix.hpp"
#include "ident/scene/scene_sections.hpp"
#include "restrictions/restriction.hpp"

namespace jointid::ident {
namespace {

using restrictions::JointSpec;
using Positions = std::map<std::int64_t, std::array<double, 3>>;

std::int64_t read_node(const std::string& key, const scene::Item& item) {
  std::int64_t node = -1;
  const char* end = key.data() + key.size();
  const auto [last, error] = std::from_chars(key.data(), end, node);
  if (error != std::errc() || last != end || node < 0) {
    item.fail("'" + key + "' is not a node number", "write \"4\" = [x, y, z]");
  }
  return node;
}

std::vector<Range> read_bands(const scene::Item& item) {
  std::vector<Range> bands;
  for (const scene::Item& band : item.list_not_empty()) {
    const Range range = band.interval();
    if (!bands.empty() && range[0] < bands.back()[1]) {
      band.fail("the band begins before the one before it ends", "bands ascend and do not overlap");
    }
    bands.push_back(range);
  }
  return bands;
}

std::string read_name(const scene::Item& item) {
  const std::string name = item.text_not_empty();
  if (name.find('.') != std::string::npos) {
    item.fail("the name '" + name + "' has a dot", "the dot parts the joint from its unknowns: left.K.a");
  }
  return name;
}

JointSpec read_joint(const scene::Item& item, std::vector<std::string> keys, const Positions& positions) {
  for (const std::string& key : kind_keys()) keys.push_back(key);
  if (const auto lines = item.open_table().find("lines")) {
    lines->fail("Z at every line has no matrices, which this command needs", "use `jointid solve`, or give matrices in place of lines");
  }
  const scene::Table table = item.table(keys);
  JointSpec joint;
  if (const auto name = table.find("name")) joint.name = read_name(*name);
  joint.dofs = table.require("dofs").dofs();
  if (const auto bands = table.find("bands")) joint.bands_hz = read_bands(*bands);
  for (const frf::Dof& dof : joint.dofs) {
    const auto position = positions.find(dof.node);
    if (position != positions.end()) joint.node_positions.insert(*position);
  }
  for (const restrictions::Kind kind : restrictions::all_kinds) {
    const auto matrix = table.find(restrictions::key(kind));
    if (!matrix) continue;
    joint.matrices[kind] = read_matrix_spec(*matrix, kind, joint);
    if (read_definite(*matrix)) joint.definite.insert(kind);
  }
  if (joint.matrices.empty()) item.fail("the joint has no matrix", "give it one of " + one_of(kind_keys()));
  return joint;
}

/// Names and DOFs of the last joint against those before it; its matrices are checked one by one elsewhere.
void check_together(const std::vector<JointSpec>& joints, const scene::Item& last) {
  std::vector<JointSpec> bare = joints;
  for (JointSpec& joint : bare) joint.matrices = {{restrictions::Kind::stiffness, restrictions::Pattern::diagonal}};
  last.here([&] { return restrictions::build(bare); });
}

}  // namespace

std::map<std::int64_t, std::array<double, 3>> read_nodes(const scene::Item& item) {
  std::map<std::int64_t, std::array<double, 3>> positions;
  const scene::Table table = item.open_table();
  for (const auto& [key, value] : table.members()) {
    const std::vector<scene::Item> coordinates = value.list();
    if (coordinates.size() != 3) {
      value.fail("a position has three coordinates, found " + std::to_string(coordinates.size()),
                 "write [x, y, z] (m)");
    }
    const auto [place, is_new] = positions.try_emplace(read_node(key, value));
    if (!is_new) value.fail("the node is here twice");
    for (std::size_t i = 0; i < 3; ++i) place->second[i] = coordinates[i].number();
  }
  return positions;
}

std::vector<JointSpec> read_joints(const scene::Table& scene) {
  const auto joint = scene.find("joint");
  const auto joints = scene.find("joints");
  if (joint && joint->is_list())
    joint->fail("[[joint]] is a list of tables", "one joint is [joint]; each of several is [[joints]]");
  if (joints && joints->is_table()) joints->fail("[joints] is one table", "write [[joints]], once for each joint, or [joint]");
  if (joint && joints) joint->fail("both [joint] and [[joints]] are given", "write every joint as [[joints]]");
  if (!joint && !joints) scene.itself().fail("the key 'joint' is missing", "declare [joint] or [[joints]]");
  const auto nodes = scene.find("nodes");
  const Positions positions = nodes ? read_nodes(*nodes) : Positions();
  if (joint) return {read_joint(*joint, {"dofs", "bands", "couple_first"}, positions)};
  std::vector<JointSpec> result;
  for (const scene::Item& item : joints->list_not_empty()) {
    result.push_back(read_joint(item, {"name", "dofs", "bands", "couple_first"}, positions));
    check_together(result, item);
  }
  return result;
}

std::vector<std::array<frf::Dof, 2>> read_couple_first(const scene::Table& scene) {
  std::vector<scene::Item> joints;
  if (const auto joint = scene.find("joint")) joints.push_back(*joint);
  if (const auto list = scene.find("joints")) joints = list->list();
  std::vector<std::array<frf::Dof, 2>> pairs;
  for (const scene::Item& joint : joints) {
    const auto couple_first = joint.open_table().find("couple_first");
    if (!couple_first) continue;
    for (const scene::Item& pair : couple_first->list_not_empty()) {
      const std::vector<frf::Dof> dofs = pair.dofs();
      if (dofs.size() != 2) pair.fail("a pair has two DOFs, found " + std::to_string(dofs.size()), "write [\"4:+RZ\", \"5:+RZ\"]");
      pairs.push_back({dofs[0], dofs[1]});
    }
  }
  return pairs;
}

}  // namespace jointid::ident
