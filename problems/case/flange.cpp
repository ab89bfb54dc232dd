#include "problems/case/flange.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/eigen.hpp"
#include "base/text.hpp"
#include "problems/case/case.hpp"
#include "problems/structure/frame.hpp"
#include "problems/structure/response.hpp"

namespace jointid::problems {
namespace {

using Vector = std::array<double, 3>;

constexpr BarSection bar = {.diameter = 0.04, .youngs_modulus = 2.1e11, .density = 7850.0};
constexpr double flange_loss_factor = 0.01, noise_level = 0.01;
constexpr double flange_mass = 2.0, flange_inertia = 3.0e-3;                           ///< kg, kg·m², of each rigid flange
constexpr double sensor_radius = 0.045, impact_radius = 0.06, half_thickness = 0.012;  ///< m
constexpr std::array<double, 6> joint_stiffness = {1.2e8, 1.4e8, 2.5e8, 3.0e5, 2.5e5, 1.5e5};  ///< N/m, N·m/rad
constexpr std::array<double, 6> joint_loss_factor = {0.06, 0.05, 0.04, 0.05, 0.05, 0.08};
constexpr Axis axis = {.start_hz = 100.0, .step_hz = 20.0, .lines = 121};

/// A part: its flange at the origin is its first node, behind it a frame.
struct Part {
  std::vector<frf::Node> frame;      ///< the flange first
  std::vector<std::int64_t> others;  ///< nodes that are measured, too
  std::int64_t first_sensor, first_impact;
  double face;  ///< m, of the sensors and impacts along z
  int number;   ///< of its virtual point
};

const std::array<Part, 2>& parts() {
  static const std::array<Part, 2> all = {
      {{{{100, {0, 0, 0}}, {101, {0, 0, -0.15}}, {102, {0, 0, -0.3}}, {103, {0.15, 0, -0.3}}, {104, {0.15, 0.12, -0.35}}},
        {102, 104},
        11,
        31,
        -half_thickness,
        1},
       {{{200, {0, 0, 0}}, {201, {0, 0, 0.2}}, {202, {0.1, 0.05, 0.35}}, {203, {0.25, 0.05, 0.4}}, {204, {0.25, -0.1, 0.45}}},
        {202, 204},
        21,
        41,
        half_thickness,
        2}}};
  return all;
}

frf::Node on_circle(std::int64_t id, double radius, double degrees, double z) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return {id, {radius * std::cos(angle), radius * std::sin(angle), z}};
}

std::vector<frf::Node> sensor_nodes(const Part& part) {
  std::vector<frf::Node> nodes;
  for (int i = 0; i < 4; ++i) nodes.push_back(on_circle(part.first_sensor + i, sensor_radius, 20.0 + 90.0 * i, part.face));
  return nodes;
}

/// Behind the sensors' face, every second one on the rim's other edge.
std::vector<frf::Node> impact_nodes(const Part& part) {
  std::vector<frf::Node> nodes;
  for (int i = 0; i < 6; ++i)
    nodes.push_back(on_circle(part.first_impact + i, impact_radius, 60.0 * i, (i % 2 == 0 ? 1.0 : -0.5) * part.face));
  return nodes;
}

std::vector<frf::Dof> translations(const std::vector<frf::Node>& nodes) {
  std::vector<frf::Dof> dofs;
  for (const frf::Node& node : nodes) {
    for (const auto direction : {frf::Direction::x, frf::Direction::y, frf::Direction::z})
      dofs.push_back({.node = node.id, .direction = direction});
  }
  return dofs;
}

std::vector<frf::Node> other_nodes(const Part& part) {
  std::vector<frf::Node> nodes;
  for (const frf::Node& node : part.frame) {
    if (std::ranges::find(part.others, node.id) != part.others.end()) nodes.push_back(node);
  }
  return nodes;
}

Structure structure_of(const Part& part) {
  Structure structure = frame(bar, part.frame);
  for (const frf::Dof& dof : frame_dofs(part.frame.front().id)) {
    structure.add(Kind::mass, {dof, {}}, dof.is_rotation() ? flange_inertia : flange_mass);
  }
  structure.add_proportional_damping(flange_loss_factor);
  return structure;
}

/// What a channel sees of some DOFs of a structure.
struct Row {
  frf::Dof dof;
  std::vector<std::pair<frf::Dof, double>> of;
};

/// d·(x + θ × r) of the flange's motion.
Row on_flange(const Part& part, const frf::Node& node, const frf::Dof& dof, const Vector& d) {
  const std::vector<frf::Dof> flange = frame_dofs(part.frame.front().id);
  const Vector& r = node.position;
  const Vector moment = {r[1] * d[2] - r[2] * d[1], r[2] * d[0] - r[0] * d[2], r[0] * d[1] - r[1] * d[0]};
  Row row{dof, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    row.of.emplace_back(flange[k], d[k]);
    row.of.emplace_back(flange[3 + k], moment[k]);
  }
  return row;
}

Vector unit(const frf::Dof& dof) {
  Vector out{};
  out[static_cast<std::size_t>(dof.direction) - 1] = 1.0;
  return out;
}

/// The turned sensor of part one.
Vector turned(const frf::Dof& dof) { return dof == frf::Dof::parse("13:+Y") ? Vector{0.0, 0.6, 0.8} : unit(dof); }

std::vector<Row> rows(const Part& part, const std::vector<frf::Node>& on, Vector (*direction)(const frf::Dof&)) {
  std::vector<Row> all;
  for (const frf::Node& node : on) {
    for (const frf::Dof& dof : translations({node})) all.push_back(on_flange(part, node, dof, direction(dof)));
  }
  for (const frf::Dof& dof : translations(other_nodes(part))) all.push_back({dof, {{dof, 1.0}}});
  return all;
}

RowMatrixXd matrix_of(const std::vector<Row>& rows, const std::vector<frf::Dof>& dofs) {
  RowMatrixXd out = RowMatrixXd::Zero(at(rows.size()), at(dofs.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const auto& [dof, factor] : rows[i].of) out(at(i), at(frf::find_coordinate(dofs, dof))) += factor;
  }
  return out;
}

/// FRFs of the channels from those of the structure's DOFs that they see.
frf::FrfSet measured(const Structure& structure, const std::vector<Row>& responses, const std::vector<Row>& references,
                     const std::string& file) {
  std::vector<frf::Dof> dofs;
  for (const auto* side : {&responses, &references}) {
    for (const Row& row : *side) {
      for (const auto& [dof, factor] : row.of) {
        if (!frf::has(dofs, dof)) dofs.push_back(dof);
      }
    }
  }
  const frf::FrfSet of_dofs =
      frequency_response(structure, {.response = dofs, .reference = dofs, .frequency_hz = frequencies(axis)});
  frf::FrfSet set{.header = of_dofs.header, .values = {}, .variance = {}, .coherence = {}};
  set.header.file = file;
  set.header.quantity = frf::Quantity::accelerance;
  set.header.response.clear();
  set.header.reference.clear();
  for (const Row& row : responses) set.header.response.push_back(row.dof);
  for (const Row& row : references) set.header.reference.push_back(row.dof);
  const RowMatrixXc left = matrix_of(responses, dofs).cast<Complex>(),
                    right = matrix_of(references, dofs).transpose().cast<Complex>();
  for (std::size_t line = 0; line < set.header.lines(); ++line) {
    const Eigen::Map<const RowMatrixXc> h(of_dofs.values.data() + line * dofs.size() * dofs.size(), at(dofs.size()),
                                          at(dofs.size()));
    const RowMatrixXc y = left * h * right;
    set.values.insert(set.values.end(), y.data(), y.data() + y.size());
  }
  set.header.nodes.clear();
  for (const Part& part : parts()) {
    for (const auto& nodes : {sensor_nodes(part), impact_nodes(part), other_nodes(part)}) {
      for (const frf::Node& node : nodes) {
        const auto is_there = [&](const std::vector<frf::Dof>& all) {
          return std::ranges::any_of(all, [&](const frf::Dof& d) { return d.node == node.id; });
        };
        if (is_there(set.header.response) || is_there(set.header.reference)) set.header.nodes.push_back(node);
      }
    }
  }
  return set;
}

std::vector<frf::Dof> joint_dofs(const std::string& first, const std::string& second) {
  std::vector<frf::Dof> dofs;
  for (const std::string& node : {first, second}) {
    for (const char* direction : {":+X", ":+Y", ":+Z", ":+RX", ":+RY", ":+RZ"}) dofs.push_back(frf::Dof::parse(node + direction));
  }
  return dofs;
}

JointMatrix joint_matrix(Kind kind, const std::vector<frf::Dof>& dofs) {
  std::vector<restrictions::Spring> ends;
  std::vector<double> values;
  for (std::size_t i = 0; i < 6; ++i) {
    ends.push_back({dofs[i], dofs[i + 6]});
    values.push_back(joint_stiffness[i] * (kind == Kind::stiffness ? 1.0 : joint_loss_factor[i]));
  }
  return springs(kind, dofs, ends, values);
}

std::string list_text(const std::vector<frf::Dof>& dofs) {
  std::string text;
  for (const frf::Dof& dof : dofs) text += (text.empty() ? "\"" : ", \"") + dof.name() + "\"";
  return "[" + text + "]";
}

std::string springs_text(const std::vector<frf::Dof>& dofs) {
  const auto spring = [&](unsigned i) { return list_text({dofs[i], dofs[i + 6]}); };
  return "springs = [" + comma_list(std::array{0U, 1U, 2U, 3U, 4U, 5U}, spring) + "]\n";
}

std::string matrix_text(const Matrix& matrix) {
  std::string text;
  for (const auto& row : matrix) {
    const std::string numbers = comma_list(row, [](double value) { return digits(value, "%.17g"); });
    text += (text.empty() ? "[" : ", [") + numbers + "]";
  }
  return "[" + text + "]";
}

std::string scene_of(const Problem& problem) {
  std::string text = "title = \"" + problem.name + ": " + problem.description + "\"\n\n[data]\nsubstructures = [\"" +
                     problem.substructures[0].header.file + "\", \"" + problem.substructures[1].header.file +
                     "\"]\nassembly = [\"" + problem.assembly.header.file + "\"]\n";
  for (const Part& part : parts()) {
    text += "\n[[virtual_points]]\nname = \"VP" + std::to_string(part.number) +
            "\"\nposition = [0.0, 0.0, 0.0]  # m\nsensors = " + list_text(translations(sensor_nodes(part))) +
            "\nimpacts = " + list_text(translations(impact_nodes(part))) + "\n";
  }
  text += "\n[frequency]\nrange = [100.0, 2500.0]  # Hz\n\n[joint]\ndofs = " + list_text(problem.joint_dofs) +
          "\n\n[joint.stiffness]\n" + springs_text(problem.joint_dofs) + "\n[joint.hysteretic_damping]\n" +
          springs_text(problem.joint_dofs) +
          "\n[identify]\nmethod = \"likelihood\"\n\n[noise]  # of the FRFs as measured\nmodel = \"circular\"\nlevel = "
          "0.01\n\n[truth]\n";
  for (const auto& [kind, matrix] : problem.truth) text += restrictions::key(kind) + " = " + matrix_text(matrix) + "\n";
  return text;
}

}  // namespace

std::vector<ProblemInfo> list_flanges() {
  return {{"flange", "two frames bolted at flanges, each with 12 sensors and 18 impacts round a virtual point, 1 % noise"},
          {"flange-turned", "flange, one sensor of which pointed another way than its name states"}};
}

bool is_flange(const std::string& name) {
  return std::ranges::any_of(list_flanges(), [&](const ProblemInfo& info) { return info.name == name; });
}

Problem make_flange(const std::string& name) {
  Problem problem;
  problem.name = name;
  problem.description = (name == "flange" ? list_flanges()[0] : list_flanges()[1]).description;
  problem.joint_dofs = joint_dofs("VP1", "VP2");
  problem.noise = frf::NoiseModel{.kind = frf::NoiseKind::circular, .level = noise_level, .reciprocal = false};
  std::vector<Structure> structures;
  std::vector<Row> all_responses, all_references;
  for (const Part& part : parts()) {
    structures.push_back(structure_of(part));
    const bool is_turned = name == "flange-turned" && part.number == 1;
    const std::vector<Row> references = rows(part, impact_nodes(part), unit), responses = rows(part, sensor_nodes(part), unit);
    problem.substructures.push_back(measured(structures.back(), is_turned ? rows(part, sensor_nodes(part), turned) : responses,
                                             references, name + "_part_" + std::to_string(part.number) + ".h5"));
    problem.substructure_modes.push_back(modes(structures.back()));
    all_responses.insert(all_responses.end(), responses.begin(), responses.end());
    all_references.insert(all_references.end(), references.begin(), references.end());
  }
  std::vector<JointMatrix> on_structure;
  for (const Kind kind : {Kind::stiffness, Kind::hysteretic_damping}) {
    const JointMatrix matrix = joint_matrix(kind, problem.joint_dofs);
    problem.truth[kind] = matrix.truth;
    problem.unknowns.insert(problem.unknowns.end(), matrix.unknowns.begin(), matrix.unknowns.end());
    on_structure.push_back(joint_matrix(kind, joint_dofs("100", "200")));
  }
  const Structure both = assembled(structures, joint_dofs("100", "200"), on_structure);
  problem.assembly = measured(both, all_responses, all_references, name + "_assembly.h5");
  problem.assembly_modes = modes(both);
  problem.scene = scene_of(problem);
  return problem;
}

}  // namespace jointid::problems
