#include "tasks/joint/joint_plate.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "base/text.hpp"
#include "frf/set/virtual_node.hpp"
#include "virtualpoint/transformation.hpp"

namespace jointid::tasks {
namespace {

constexpr std::array<frf::Direction, 6> motions = {frf::Direction::x,  frf::Direction::y,  frf::Direction::z,
                                                   frf::Direction::rx, frf::Direction::ry, frf::Direction::rz};

[[noreturn]] void no_plate(std::string problem, std::string remedy) {
  throw InputError({ErrorKind::data, "", "", std::move(problem), std::move(remedy)});
}

/// The parts of the first and of the second node of the first pair.
std::array<const frf::FrfHeader*, 2> sides_of(const NodePair& pair, const std::vector<frf::FrfHeader>& parts) {
  std::array<const frf::FrfHeader*, 2> out{};
  for (const frf::FrfHeader& part : parts) {
    const std::vector<std::int64_t> nodes = couplable_nodes(part);
    for (const std::size_t side : {0U, 1U}) {
      if (out[side] == nullptr && std::ranges::find(nodes, side == 0 ? pair.first : pair.second) != nodes.end()) out[side] = &part;
    }
  }
  if (out[0] == nullptr || out[1] == nullptr || out[0] == out[1]) no_plate("the pairs are not of two parts", "tick pairs of two parts");
  return out;
}

/// On which side of the first pair a node of another pair is: pairs may name their parts in either order.
bool is_of(const frf::FrfHeader& part, std::int64_t node) {
  const std::vector<std::int64_t> nodes = couplable_nodes(part);
  return std::ranges::find(nodes, node) != nodes.end();
}

std::string dofs_list(const std::vector<frf::Dof>& dofs) {
  return "[" + comma_list(dofs, [](const frf::Dof& dof) { return '"' + dof.name() + '"'; }) + "]";
}

/// Throws InputError where the channels do not determine the six motions.
void require_determined(const Plate& plate, std::size_t side, const frf::FrfHeader& part) {
  virtualpoint::VirtualPoint point;
  point.number = static_cast<std::int64_t>(side) + 1;
  point.position = plate.position;
  point.modes = virtualpoint::rigid_modes();
  for (const frf::Dof& dof : plate.channels[side]) point.sensors.push_back({.dof = dof});
  virtualpoint::transformation(point, virtualpoint::Side::sensors, part);
}

}  // namespace

Plate plate_of(const std::vector<NodePair>& pairs, const std::vector<frf::FrfHeader>& parts) {
  if (pairs.empty()) no_plate("no pair of nodes is ticked", "tick the pairs that the plates share");
  const auto sides = sides_of(pairs.front(), parts);
  Plate plate;
  double nodes = 0.0;
  for (const NodePair& pair : pairs) {
    const bool turned = is_of(*sides[1], pair.first);
    for (const std::size_t side : {0U, 1U}) {
      const std::int64_t node = (side == 0) != turned ? pair.first : pair.second;
      if (!is_of(*sides[side], node)) no_plate("node " + std::to_string(node) + " is of a third part", "tick pairs of two parts");
      const auto found = std::ranges::find(sides[side]->nodes, node, &frf::Node::id);
      if (found == sides[side]->nodes.end())
        no_plate("node " + std::to_string(node) + " has no position", "add positions to the file, or choose springs");
      for (std::size_t axis = 0; axis < 3; ++axis) plate.position[axis] += found->position[axis];
      nodes += 1.0;
      for (const frf::Direction direction : pair.directions) {
        if (const frf::Dof dof{node, direction}; !frf::has(plate.channels[side], dof)) plate.channels[side].push_back(dof);
      }
    }
  }
  for (double& coordinate : plate.position) coordinate /= nodes;
  for (const std::size_t side : {0U, 1U}) require_determined(plate, side, *sides[side]);
  return plate;
}

std::vector<frf::Dof> plate_dofs() {
  std::vector<frf::Dof> out;
  for (const std::int64_t point : {1, 2}) {
    for (const frf::Direction direction : motions) out.push_back({frf::virtual_node(point, frf::VirtualNode::rigid), direction});
  }
  return out;
}

std::string virtual_point_text(const Plate& plate, std::size_t side) {
  const std::string channels = dofs_list(plate.channels[side]);
  return "name = \"VP" + std::to_string(side + 1) + "\"\nposition = [" +
         comma_list(plate.position, [](double coordinate) { return digits(coordinate, "%.12g"); }) + "]  # m\nsensors = " + channels +
         "\nimpacts = " + channels + "\n";
}

}  // namespace jointid::tasks
