#include "problems/case/catalogue.hpp"
#include "problems/case/thesis_beams.hpp"

namespace jointid::problems {
namespace {

Case accuracy_case(const std::string& name, const std::string& description, const Axis& axis) {
  Case definition = basic_case(name, description);
  definition.axis = axis;
  definition.weighting = "WB";
  return definition;
}

Case soft_joint(const std::string& name, const std::string& description, const Axis& axis) {
  Case definition = accuracy_case(name, description, axis);
  set_joint(definition, {symmetric(Kind::stiffness, scaled(joint_stiffness(), 0.01))});
  return definition;
}

constexpr double rotary_spring = 1987.2;  ///< N·m/rad, case D

Matrix two_rotary_springs() {
  return scaled({{1.0, 0.0, -1.0, 0.0}, {0.0, 1.0, 0.0, -1.0}, {-1.0, 0.0, 1.0, 0.0}, {0.0, -1.0, 0.0, 1.0}},
                rotary_spring);
}

/// Case D: A of five elements (nodes 1–6), B one short element (nodes 7, 8) beside its nodes 3 and 4, joined
/// in rotation.
Case short_substructure(const std::string& name, const std::string& description,
                        const JointMatrix& stiffness) {
  Case definition = accuracy_case(name, description, {.start_hz = 40.0, .step_hz = 20.0, .lines = 24});
  Structure a = beam(thesis_section(), {.first_node = 1, .x = {0.0, 0.3, 0.6, 0.9, 1.2, 1.5}});
  Structure b = beam(thesis_section(), {.first_node = 7, .x = {0.7, 0.8}, .y = 0.1});
  a.add_proportional_damping(0.001);
  b.add_proportional_damping(0.001);
  definition.substructures = {a, b};
  definition.joint_dofs = coordinates({6, 8, 14, 16});
  set_joint(definition, {stiffness});
  return definition;
}

JointMatrix springs_with_six_unknowns() {
  const double k = rotary_spring;
  return expressed(
      Kind::stiffness, two_rotary_springs(),
      {{"x1", "x2", "x3", 0.0}, {"x2", "x5", 0.0, "x7"}, {"x3", 0.0, "x1", 0.0}, {0.0, "x7", 0.0, "x10"}},
      {{"x1", k}, {"x2", 0.0}, {"x3", -k}, {"x5", k}, {"x7", -k}, {"x10", k}});
}

JointMatrix springs_with_three_unknowns() {
  return expressed(Kind::stiffness, two_rotary_springs(),
                   {{rotary_spring, 0.0, -rotary_spring, 0.0},
                    {0.0, rotary_spring, 0.0, -rotary_spring},
                    {-rotary_spring, 0.0, "x8", "x9"},
                    {0.0, -rotary_spring, "x9", "x10"}},
                   {{"x8", rotary_spring}, {"x9", 0.0}, {"x10", rotary_spring}});
}

/// docs/formulas.md §13 (6.74) with L = 0.3 m.
JointMatrix beam_with_one_unknown() {
  return expressed(Kind::stiffness, joint_stiffness(),
                   {{"12*y", "1.8*y", "-12*y", "1.8*y"},
                    {"1.8*y", "0.36*y", "-1.8*y", "0.18*y"},
                    {"-12*y", "-1.8*y", "12*y", "-1.8*y"},
                    {"1.8*y", "0.18*y", "-1.8*y", "0.36*y"}},
                   {{"y", joint_stiffness()[0][0] / 12.0}});
}

/// A spring to ground or a mass at a coordinate of the substructure B.
struct Attachment {
  Kind kind;
  int coordinate;
  double value;
};

/// Cases E and F: B has 1 % of the mass, the joint neither mass nor damping.
Case light_substructure(const std::string& name, const std::string& description, const Axis& axis,
                        const std::vector<Attachment>& attachments = {}) {
  Case definition = accuracy_case(name, description, axis);
  Structure b = substructure_b(0.01);
  for (const Attachment& item : attachments) {
    b.add(item.kind, {.first = coordinates({item.coordinate})[0], .second = {}}, item.value);
  }
  definition.substructures = {substructure_a(), b};
  set_joint(definition, {symmetric(Kind::stiffness, joint_stiffness())});
  return definition;
}

constexpr Axis low = {.start_hz = 100.0, .step_hz = 10.0, .lines = 31};
constexpr Axis high = {.start_hz = 600.0, .step_hz = 30.0, .lines = 35};

Case one_unknown() {
  Case definition = light_substructure("E2", "E1 with one unknown, K known up to a factor (§6.8.4.3)", low);
  set_joint(definition, {beam_with_one_unknown()});
  return definition;
}

}  // namespace

std::vector<Case> cases_of_accuracy() {
  return {
      soft_joint("C1", "soft joint, 1 % of the beam element: hardly seen at 400-1000 Hz (§6.8.4.1)",
                 {400.0, 20.0, 31}),
      soft_joint("C2", "C1 at 1-50 Hz, where the joint is seen (§6.8.4.1)", {1.0, 1.0, 50}),
      short_substructure(
          "D1", "two rotary springs to a short light beam (0.1 m): 10 unknowns, not separable (§6.8.4.2)",
          symmetric(Kind::stiffness, two_rotary_springs())),
      short_substructure("D2", "D1 with the restriction (6.69): six unknowns, separable (§6.8.4.2)",
                         springs_with_six_unknowns()),
      short_substructure("D3", "D1 with x1 to x7 known: three unknowns, not separable (§6.8.4.2)",
                         springs_with_three_unknowns()),
      light_substructure("E1", "light substructure B: the joint hardly deforms at 100-400 Hz (§6.8.4.3)",
                         low),
      one_unknown(),
      light_substructure("E3", "E1 at 600-1620 Hz, where the joint deforms (§6.8.4.3)", high),
      light_substructure("F1", "E1 with the end of B on a spring and a rotary spring to ground (§6.8.5)", low,
                         {{Kind::stiffness, 13, 662400.0}, {Kind::stiffness, 14, 1987.2}}),
      light_substructure("F2", "E1 with a mass of 1 kg at the end of B (§6.8.5)", low,
                         {{Kind::mass, 13, 1.0}}),
      light_substructure("F3", "E1 with masses of 2 kg at both ends of B (§6.8.5)", low,
                         {{Kind::mass, 9, 2.0}, {Kind::mass, 13, 2.0}}),
  };
}

}  // namespace jointid::problems
