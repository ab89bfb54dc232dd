#include "problems/vibration/law_problem_cases.hpp"

#include <algorithm>

#include "problems/structure/beam.hpp"
#include "problems/vibration/rig_two.hpp"

namespace jointid::problems {
namespace {

frf::Dof across(std::int64_t node) { return {.node = node, .direction = frf::Direction::y}; }

std::vector<double> lines(double from, double step, int count) {
  std::vector<double> all;
  for (int i = 0; i < count; ++i) all.push_back(from + step * i);
  return all;
}

/// A steel strip along x; its first node is held by springs where it is clamped.
Structure strip(std::int64_t first_node, double from, int elements, bool clamped) {
  constexpr BeamSection section = {.width = 0.04, .thickness = 0.008, .youngs_modulus = 2.1e11, .density = 7850.0};
  constexpr double element = 0.1, clamp = 1e8;
  BeamLine line = {.first_node = first_node, .x = {}};
  for (int i = 0; i <= elements; ++i) line.x.push_back(from + element * i);
  Structure structure = beam(section, line);
  if (clamped) {
    for (const frf::Dof& dof : beam_dofs(first_node)) structure.add(Kind::stiffness, {dof}, {{clamp}});
  }
  structure.add_proportional_damping(0.004);
  return structure;
}

}  // namespace

LawProblem frame_with_joints() {
  Structure left = strip(1, 0.0, 4, true), right = strip(21, 0.6, 4, false), girder = strip(11, 0.3, 4, false);
  right.add(Kind::stiffness, {across(25)}, {{1e8}});
  right.add(Kind::stiffness, {beam_dofs(25)[1]}, {{1e8}});
  return {.name = "frame-laws",
          .description = "three strips with two friction joints between them (bilinear, Ren) at four force levels",
          .parts = {left, girder, right},
          .joints = {{"left", {across(5), across(12)}, "bilinear", {4e-6, 1e6}, {"bilinear", "ren"}},
                     {"right", {across(14), across(22)}, "ren", {1e-6, 2.0, 1.5e6}, {"bilinear", "ren"}}},
          .responses = {across(3), across(5), across(11), across(13), across(15), across(22), across(23)},
          .force = across(13),
          .levels = {1.0, 4.0, 12.0, 30.0},
          .frequency_hz = lines(40.0, 8.0, 6),
          .model = {1, 3, 5, 7, 9, 11}};
}

LawProblem mass_with_iwan() {
  const frf::Dof dof = across(1);
  Structure mass({{.id = 1}}, {dof});
  mass.add(Kind::mass, {dof}, {{1.0}});
  mass.add(Kind::stiffness, {dof}, {{2e5}});
  mass.add(Kind::viscous_damping, {dof}, {{2.0}});
  return {.name = "sdof-iwan",
          .description = "one mass with an Iwan joint to ground at four force levels",
          .parts = {mass},
          .joints = {{"joint", {dof, {}}, "iwan", {10.0, 4e5, -0.4, 0.5}, {"bilinear", "shoukry", "ren", "iwan"}}},
          .responses = {dof},
          .force = dof,
          .levels = {0.5, 2.0, 5.0, 12.0},
          .frequency_hz = lines(80.0, 5.0, 12)};
}

LawProblem rig_two_with_ren() {
  const auto [first, second] = rig_two_middles();
  const RigTwo rig = make_rig_two("rig2");
  return {
      .name = "rig2-laws",
      .description = "rig two (200 N) with its Ren joint, which moves a hundred times less than the beams, at six force levels",
      .parts = {rig_two_structure()},
      .joints = {{"joint", {first, second}, "ren", rig.element, {"bilinear", "ren"}}},
      .responses = {first, second},
      .force = first,
      .levels = {1.0, 2.0, 4.0, 8.0, 12.0, 16.0},
      .frequency_hz = lines(48.0, 1.1, 8),
      .noise = 0.003};
}

namespace {

const std::vector<LawProblem>& all_law_problems() {
  static const std::vector<LawProblem> all = {frame_with_joints(), mass_with_iwan(), rig_two_with_ren()};
  return all;
}

}  // namespace

std::vector<ProblemInfo> list_law_problems() {
  std::vector<ProblemInfo> all;
  for (const LawProblem& problem : all_law_problems()) all.push_back({problem.name, problem.description});
  return all;
}

bool is_law_problem(const std::string& name) {
  return std::ranges::find(all_law_problems(), name, &LawProblem::name) != all_law_problems().end();
}

LawProblem make_law_problem(const std::string& name) {
  std::vector<std::string> names;
  for (const LawProblem& problem : all_law_problems()) {
    if (problem.name == name) return problem;
    names.push_back(problem.name);
  }
  refuse_problem("there is no problem '" + name + "' with friction laws", name, names);
}

}  // namespace jointid::problems
