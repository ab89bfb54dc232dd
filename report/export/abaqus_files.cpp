#include <fmt/format.h>

#include <array>

#include "report/export/export_parts.hpp"

namespace jointid::report {
namespace {

std::string starred(const std::string& text) { return "** " + text + "\n"; }

std::string exact(double value) { return fmt::format("{:.16E}", value); }

void require_stiffness(const ExportedMatrices& of, const Link& link) {
  if (link.has(Kind::hysteretic_damping) && !link.has(Kind::stiffness))
    of.refuse(of.remark(Kind::hysteretic_damping, link) + ": structural damping is a factor of a stiffness that is not there",
              "write whole matrices: --as matrix");
}

/// Element, its set, and a section of one line of DOFs and one of values.
std::string link_cards(const ExportedMatrices& of, const Link& link, std::size_t id, const std::string& type,
                       const std::string& section, const std::string& values) {
  const frf::Dof& first = of.dofs()[link.first];
  std::string nodes = std::to_string(first.node), components = std::to_string(component(first));
  if (link.second) {
    nodes += ", " + std::to_string(of.dofs()[*link.second].node);
    components += ", " + std::to_string(component(of.dofs()[*link.second]));
  }
  return fmt::format("*ELEMENT, TYPE={0}{1}, ELSET=JOINT{2}\n{2}, {3}\n*{4}, ELSET=JOINT{2}{5}\n{6}\n{7}\n", type,
                     link.second ? 2 : 1, id, nodes, type, section, components, values);
}

std::string spring_text(const ExportedMatrices& of) {
  if (of.has(Kind::mass)) of.refuse("*SPRING and *DASHPOT have no mass, and the joint has", "write whole matrices: --as matrix");
  std::string text;
  std::size_t id = of.options().first_id;
  for (const Link& link : of.links()) {
    require_stiffness(of, link);
    if (link.has(Kind::stiffness)) {
      const double k = link.of(Kind::stiffness).value, d = link.of(Kind::hysteretic_damping).value;
      text += starred(of.remark(Kind::stiffness, link));
      if (d != 0.0) text += starred("structural damping factor D/K: " + of.remark(Kind::hysteretic_damping, link));
      text += link_cards(of, link, id++, "SPRING", d == 0.0 ? "" : ", COMPLEX STIFFNESS",
                         exact(k) + (d == 0.0 ? "" : ", " + exact(d / k)));
    }
    if (link.has(Kind::viscous_damping)) {
      text += starred(of.remark(Kind::viscous_damping, link));
      text += link_cards(of, link, id++, "DASHPOT", "", exact(link.of(Kind::viscous_damping).value));
    }
  }
  return text;
}

std::string connector_text(const ExportedMatrices& of) {
  std::string text = starred("connectors between nodes at one place. Apart, their forces make moments: use springs there.");
  std::size_t id = of.options().first_id;
  for (const Bush& bush : bushes(of)) {
    text += fmt::format("*ELEMENT, TYPE=CONN3D2, ELSET=JOINT{0}\n{0}, {1}, {2}\n", id, bush.first,
                        bush.second ? std::to_string(*bush.second) : "");
    text += fmt::format(
        "*CONNECTOR SECTION, ELSET=JOINT{0}, BEHAVIOR=JOINT{0}\nCARTESIAN, CARDAN\n*CONNECTOR BEHAVIOR, NAME=JOINT{0}\n", id);
    for (const auto& [direction, link] : bush.by_direction) {
      require_stiffness(of, link);
      const double k = link.of(Kind::stiffness).value;
      for (const auto& [kind, value] : link.by_kind) {
        text += starred(of.remark(kind, link));
        if (kind == Kind::stiffness)
          text += fmt::format("*CONNECTOR ELASTICITY, COMPONENT={}\n{}\n", direction, exact(value.value));
        if (kind == Kind::viscous_damping)
          text += fmt::format("*CONNECTOR DAMPING, COMPONENT={}\n{}\n", direction, exact(value.value));
        if (kind == Kind::hysteretic_damping)
          text += starred("factor D/K") +
                  fmt::format("*CONNECTOR DAMPING, TYPE=STRUCTURAL, COMPONENT={}\n{}\n", direction, exact(value.value / k));
      }
    }
    ++id;
  }
  return text;
}

std::string matrix_text(const ExportedMatrices& of) {
  std::string text;
  std::string assembled;
  constexpr std::array words = {std::pair{Kind::stiffness, "STIFFNESS"}, std::pair{Kind::mass, "MASS"},
                                std::pair{Kind::viscous_damping, "VISCOUS DAMPING"},
                                std::pair{Kind::hysteretic_damping, "STRUCTURAL DAMPING"}};
  for (const auto& [kind, word] : words) {
    if (!of.has(kind)) continue;
    const bool symmetric = of.is_symmetric(kind);
    const std::string name = "JOINT_" + restrictions::symbol(kind);
    text += fmt::format("*MATRIX INPUT, NAME={}, TYPE={}\n", name, symmetric ? "SYMMETRIC" : "UNSYMMETRIC");
    for (std::size_t i = 0; i < of.size(); ++i) {
      for (std::size_t j = symmetric ? i : 0; j < of.size(); ++j) {
        const double value = of.at(kind, i, j).value;
        if (value == 0.0) continue;
        const frf::Dof &row = of.dofs()[i], &column = of.dofs()[j];
        text += starred(of.remark(kind, i, j)) +
                fmt::format("{}, {}, {}, {}, {}\n", row.node, component(row), column.node, component(column), exact(value));
      }
    }
    assembled += fmt::format("*MATRIX ASSEMBLE, {}={}\n", word, name);
  }
  return text + assembled;
}

}  // namespace

std::vector<ExportFile> abaqus_files(const ExportedMatrices& of, ExportWay way) {
  std::string text;
  for (const std::string& line : of.head()) text += starred(line);
  if (way == ExportWay::springs) text += spring_text(of);
  if (way == ExportWay::bush) text += connector_text(of);
  if (way == ExportWay::matrix) text += matrix_text(of);
  return {{".inp", text}};
}

}  // namespace jointid::report
