#include "problems/structure/beam.hpp"

namespace jointid::problems {
Matrix element_stiffness(const BeamSection& section, double length) {
  const double h = section.thickness;
  const double bending = section.youngs_modulus * section.width * h * h * h / 12.0;
  const double l = length;
  return scaled({{12.0, 6.0 * l, -12.0, 6.0 * l},
                 {6.0 * l, 4.0 * l * l, -6.0 * l, 2.0 * l * l},
                 {-12.0, -6.0 * l, 12.0, -6.0 * l},
                 {6.0 * l, 2.0 * l * l, -6.0 * l, 4.0 * l * l}},
                bending / (l * l * l));
}

Matrix element_mass(const BeamSection& section, double length) {
  const double l = length;
  return scaled({{156.0, 22.0 * l, 54.0, -13.0 * l},
                 {22.0 * l, 4.0 * l * l, 13.0 * l, -3.0 * l * l},
                 {54.0, 13.0 * l, 156.0, -22.0 * l},
                 {-13.0 * l, -3.0 * l * l, -22.0 * l, 4.0 * l * l}},
                section.density * section.width * section.thickness * l / 420.0);
}

std::vector<frf::Dof> beam_dofs(std::int64_t node) {
  return {{.node = node, .direction = frf::Direction::y}, {.node = node, .direction = frf::Direction::rz}};
}

Structure beam(const BeamSection& section, const BeamLine& line) {
  std::vector<frf::Node> nodes;
  std::vector<frf::Dof> dofs;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    const std::int64_t id = line.first_node + static_cast<std::int64_t>(i);
    nodes.push_back({.id = id, .position = {line.x[i], line.y, 0.0}});
    for (const frf::Dof& dof : beam_dofs(id)) dofs.push_back(dof);
  }
  Structure result(std::move(nodes), std::move(dofs));
  for (std::size_t i = 0; i + 1 < line.x.size(); ++i) {
    const auto first = result.dofs().begin() + static_cast<std::ptrdiff_t>(2 * i);
    const std::vector<frf::Dof> at(first, first + 4);
    const double length = line.x[i + 1] - line.x[i];
    result.add(Kind::stiffness, at, element_stiffness(section, length));
    result.add(Kind::mass, at, element_mass(section, length));
  }
  return result;
}

}  // namespace jointid::problems
