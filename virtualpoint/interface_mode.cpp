#include "virtualpoint/interface_mode.hpp"

#include "frf/set/virtual_node.hpp"

namespace jointid::virtualpoint {
namespace {

using enum InterfaceMode;
using frf::Direction;

/// Node and direction of a mode, in the order of the enumerators.
struct Place {
  frf::VirtualNode kind;
  Direction direction;
};

constexpr std::array<Place, 18> places = {{{frf::VirtualNode::rigid, Direction::x},
                                           {frf::VirtualNode::rigid, Direction::y},
                                           {frf::VirtualNode::rigid, Direction::z},
                                           {frf::VirtualNode::rigid, Direction::rx},
                                           {frf::VirtualNode::rigid, Direction::ry},
                                           {frf::VirtualNode::rigid, Direction::rz},
                                           {frf::VirtualNode::extension, Direction::x},
                                           {frf::VirtualNode::extension, Direction::y},
                                           {frf::VirtualNode::extension, Direction::z},
                                           {frf::VirtualNode::extension, Direction::rx},
                                           {frf::VirtualNode::extension, Direction::ry},
                                           {frf::VirtualNode::extension, Direction::rz},
                                           {frf::VirtualNode::skewing, Direction::x},
                                           {frf::VirtualNode::skewing, Direction::rx},
                                           {frf::VirtualNode::skewing, Direction::y},
                                           {frf::VirtualNode::skewing, Direction::ry},
                                           {frf::VirtualNode::skewing, Direction::z},
                                           {frf::VirtualNode::skewing, Direction::rz}}};

}  // namespace

const std::vector<std::string>& mode_names() {
  static const std::vector<std::string> names = {"ux", "uy", "uz", "rx",  "ry",  "rz",  "ex",  "ey",  "ez",
                                                 "tx", "ty", "tz", "sxy", "sxz", "syz", "syx", "szx", "szy"};
  return names;
}

std::vector<InterfaceMode> rigid_modes() { return {ux, uy, uz, rx, ry, rz}; }

std::vector<InterfaceMode> plane_modes(const std::string& plane) {
  if (plane == "XY") return {ux, uy, rz};
  if (plane == "YZ") return {uy, uz, rx};
  return {ux, uz, ry};
}

Vector displacement(InterfaceMode mode, const Vector& r) {
  const auto [x, y, z] = r;
  const std::array<Vector, 18> fields = {{{1, 0, 0},
                                          {0, 1, 0},
                                          {0, 0, 1},
                                          {0, -z, y},
                                          {z, 0, -x},
                                          {-y, x, 0},
                                          {x, 0, 0},
                                          {0, y, 0},
                                          {0, 0, z},
                                          {0, -x * z, x * y},
                                          {y * z, 0, -x * y},
                                          {-y * z, x * z, 0},
                                          {x * y, 0, 0},
                                          {x * z, 0, 0},
                                          {0, y * z, 0},
                                          {0, x * y, 0},
                                          {0, 0, x * z},
                                          {0, 0, y * z}}};
  return fields[static_cast<std::size_t>(mode)];
}

Vector rotation(InterfaceMode mode) {
  Vector axis{};
  if (mode >= rx && mode <= rz) axis[static_cast<std::size_t>(mode) - static_cast<std::size_t>(rx)] = 1.0;
  return axis;
}

frf::Dof dof_of(InterfaceMode mode, std::int64_t number) {
  const Place& place = places[static_cast<std::size_t>(mode)];
  return {.node = frf::virtual_node(number, place.kind), .direction = place.direction};
}

}  // namespace jointid::virtualpoint
