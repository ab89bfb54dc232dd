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

Case rig(const std::string& name, const std::string& description, double mass) {
  Case definition;
  definition.name = name;
  definition.description = description;
  definition.substructures = {long_beam(), short_beam()};
  definition.joint_dofs = translations({125, 126, 201, 202});
  definition.joint = {symmetric(Kind::stiffness, mirrored(2.77, 1.505, -2.13, -2.08, 1e6)),
                      symmetric(Kind::hysteretic_damping, mirrored(2.465, 1.6, -1.775, -1.93, 1e5))};
  definition.assembly = assembled(definition.substructures, definition.joint_dofs, definition.joint);
  definition.measured_substructures =
      translations({101, 107, 113, 119, 125, 126, 201, 202, 207, 212, 217, 222});
  definition.measured_assembly = definition.measured_substructures;
  definition.axis = {.start_hz = 96.0, .step_hz = 4.0, .lines = 401};
  definition.weighting = "WBG";
  definition.noise = frf::NoiseModel{.kind = frf::NoiseKind::hammer, .averages = 5};
  definition.hammer = HammerCoherence{};
  definition.quantity = frf::Quantity::accelerance;
  definition.window_rate = 8.0;
  definition.accelerometer_mass = mass;
  return definition;
}

}  // namespace

std::vector<Case> cases_of_rig_one() {
  return {
      rig("rig1", "replica of rig one: two aluminium beams and joint B, hammer test, accelerances (§7.2)",
          0.0),
      rig("rig1-accelerometer", "rig1 with the 3 g of the roving accelerometer in the data (§7.2)",
          accelerometer_mass),
  };
}

}  // namespace jointid::problems
