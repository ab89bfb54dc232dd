#include "problems/case/catalogue.hpp"
#include "problems/structure/beam.hpp"

namespace jointid::problems {
namespace {

constexpr BeamSection aluminium = {
    .width = 0.0254, .thickness = 0.0127, .youngs_modulus = 7.0e10, .density = 2710.0};
constexpr double aluminium_loss_factor = 0.0005;
constexpr double gap = 0.03;                  ///< m between the beams, bridged by the joint
constexpr double accelerometer_mass = 0.003;  ///< kg, B&K 8303

/// Finite elements of `length`/count each through `from` (excluded) to `from` + `length`.
void append_elements(std::vector<double>& x, double length, int count) {
  const double from = x.back();
  for (int i = 1; i <= count; ++i) x.push_back(from + length * i / count);
}

/// Beam 1 ends at x = 1.02 m, beam 2 begins a gap further; elements of at most 46 mm against a wavelength of
/// 260 mm at 1.7 kHz. The last 40 mm next to the joint are one element between its two joint coordinates.
Structure long_beam() {
  std::vector<double> x = {0.0};
  for (int i = 0; i < 4; ++i) append_elements(x, 0.245, 6);
  append_elements(x, 0.04, 1);
  Structure result = beam(aluminium, {.first_node = 101, .x = x});
  result.add_proportional_damping(aluminium_loss_factor);
  return result;
}

Structure short_beam() {
  std::vector<double> x = {1.02 + gap};
  append_elements(x, 0.04, 1);
  for (int i = 0; i < 4; ++i) append_elements(x, 0.2175, 5);
  Structure result = beam(aluminium, {.first_node = 201, .x = x});
  result.add_proportional_damping(aluminium_loss_factor);
  return result;
}

std::vector<frf::Dof> translations(const std::vector<std::int64_t>& nodes) {
  std::vector<frf::Dof> result;
  for (const std::int64_t node : nodes) result.push_back({.node = node, .direction = frf::Direction::y});
  return result;
}

/// The form (7.1), docs/formulas.md §13, that the symmetry of the joint gives.
Matrix mirrored(double a, double b, double c, double d, double unit) {
  return scaled({{a, b, c, d}, {b, a, d, c}, {c, d, a, b}, {d, c, b, a}}, unit);
}

/// The beams with a joint between them.
Case beams_with(const std::string& name, const std::string& description, const Matrix& stiffness, const Matrix& damping) {
  Case definition;
  definition.name = name;
  definition.description = description;
  definition.substructures = {long_beam(), short_beam()};
  definition.joint_dofs = translations({125, 126, 201, 202});
  definition.joint = {symmetric(Kind::stiffness, stiffness), symmetric(Kind::hysteretic_damping, damping)};
  definition.assembly = assembled(definition.substructures, definition.joint_dofs, definition.joint);
  definition.measured_substructures =
      translations({101, 107, 113, 119, 125, 126, 201, 202, 207, 212, 217, 222});
  definition.measured_assembly = definition.measured_substructures;
  definition.weighting = "WBG";
  definition.quantity = frf::Quantity::accelerance;
  return definition;
}

Case rig(const std::string& name, const std::string& description, double mass) {
  Case definition = beams_with(name, description, mirrored(2.77, 1.505, -2.13, -2.08, 1e6), mirrored(2.465, 1.6, -1.775, -1.93, 1e5));
  definition.axis = {.start_hz = 96.0, .step_hz = 4.0, .lines = 401};
  definition.noise = frf::NoiseModel{.kind = frf::NoiseKind::hammer, .averages = 5};
  definition.hammer = HammerCoherence{};
  definition.window_rate = 8.0;
  definition.accelerometer_mass = mass;
  return definition;
}

/// Without an exponential window, errors of 2 %: what the thesis's three data sets are compared on.
Case plain_rig(const std::string& name, const std::string& description, const Matrix& stiffness, const Matrix& damping) {
  Case definition = beams_with(name, description, stiffness, damping);
  definition.axis = {.start_hz = 96.0, .step_hz = 8.0, .lines = 201};
  definition.noise = frf::NoiseModel{.kind = frf::NoiseKind::circular, .level = 0.02};
  return definition;
}

/// Joint A of Table 7.2, nearly rigid: the mean of case A1 over (7.1), without a force under rigid motion.
Case rigid_rig() {
  Case definition = plain_rig("rig1-rigid", "rig1 with joint A, nearly rigid: couple, do not identify (Table 7.2)",
                              mirrored(3.89, -1.86, -3.89, 1.86, 1e7), mirrored(2.46, -1.73, -2.46, 1.73, 1e6));
  definition.equations = {"nn", "nj"};
  return definition;
}

/// K and D by the eight letters of (7.1).
JointMatrix lettered(Kind kind, double a, double b, double c, double d, double unit) {
  return expressed(kind, mirrored(a, b, c, d, unit),
                   {{"a", "b", "c", "d"}, {"b", "a", "d", "c"}, {"c", "d", "a", "b"}, {"d", "c", "b", "a"}},
                   {{"a", a * unit}, {"b", b * unit}, {"c", c * unit}, {"d", d * unit}});
}

/// Table 7.5: eight unknowns from H_nn of the assembly alone, from the print's start. The joint is the projection of joint B that leaves
/// the assembly free: from the print's start no method finds joint B itself, which ties it to ground.
Case inaccessible_rig() {
  Case definition = plain_rig("rig1-inaccessible", "the beams of rig1, eight unknowns from H_nn alone (Table 7.5)",
                              mirrored(2.45, 1.7925, -2.45, -1.7925, 1e6), mirrored(2.12, 1.765, -2.12, -1.765, 1e5));
  definition.joint = {lettered(Kind::stiffness, 2.45, 1.7925, -2.45, -1.7925, 1e6),
                      lettered(Kind::hysteretic_damping, 2.12, 1.765, -2.12, -1.765, 1e5)};
  definition.measured_assembly = translations({101, 107, 113, 119, 207, 212, 217, 222});
  definition.axis = {.start_hz = 96.0, .step_hz = 16.0, .lines = 101};
  definition.method = "newton";
  definition.weighting.clear();
  definition.start_stiffness = mirrored(10.0, 0.0, -5.0, -5.0, 1e6);
  definition.start_damping = mirrored(10.0, 0.0, -5.0, -5.0, 1e3);
  return definition;
}

}  // namespace

std::vector<Case> cases_of_rig_one() {
  return {
      rig("rig1", "replica of rig one: two aluminium beams and joint B, hammer test, accelerances (§7.2)",
          0.0),
      rig("rig1-accelerometer", "rig1 with the 3 g of the roving accelerometer in the data (§7.2)",
          accelerometer_mass),
      plain_rig("rig1-sets", "rig1 with joint B, 2 % errors, for data sets 1 to 3 (Table 7.3)",
                mirrored(2.77, 1.505, -2.13, -2.08, 1e6), mirrored(2.465, 1.6, -1.775, -1.93, 1e5)),
      rigid_rig(),
      inaccessible_rig(),
  };
}

}  // namespace jointid::problems
