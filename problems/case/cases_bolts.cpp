#include "problems/case/catalogue.hpp"
#include "problems/structure/brick.hpp"

namespace jointid::problems {
namespace {

using restrictions::Spring;

constexpr Solid bolted_material = {.youngs_modulus = 7.0e10, .poissons_ratio = 0.33, .density = 2700.0};  // aluminium
constexpr double block_loss_factor = 0.004;
constexpr Block lower = {.first_node = 101, .origin = {0.0, 0.0, 0.0}, .size = {0.4, 0.2, 0.05}, .elements = {4, 2, 1}};
constexpr Block upper = {.first_node = 201, .origin = {0.2, 0.0, 0.05}, .size = {0.4, 0.2, 0.05}, .elements = {4, 2, 1}};

Structure damped_block(const Block& block) {
  Structure structure = solid_block(bolted_material, block);
  structure.add_proportional_damping(block_loss_factor);
  return structure;
}

std::vector<frf::Dof> solid_directions(const std::vector<std::int64_t>& nodes) {
  std::vector<frf::Dof> dofs;
  for (const std::int64_t node : nodes) {
    for (const auto direction : {frf::Direction::x, frf::Direction::y, frf::Direction::z})
      dofs.push_back({.node = node, .direction = direction});
  }
  return dofs;
}

/// The blocks overlap over 0.2 m; the bolts are at the corners of the overlap, between the upper face of the lower block and the
/// lower face of the upper one.
const std::vector<std::int64_t> bolts_below = {lower.node(2, 0, 1), lower.node(4, 0, 1), lower.node(2, 2, 1), lower.node(4, 2, 1)};
const std::vector<std::int64_t> bolts_above = {upper.node(0, 0, 0), upper.node(2, 0, 0), upper.node(0, 2, 0), upper.node(2, 2, 0)};

std::vector<frf::Dof> joined(std::vector<frf::Dof> a, const std::vector<frf::Dof>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::vector<frf::Dof> bolt_dofs() { return joined(solid_directions(bolts_below), solid_directions(bolts_above)); }

/// Six further nodes of each block, all directions.
std::vector<frf::Dof> other_dofs() {
  return joined(solid_directions({lower.node(0, 0, 0), lower.node(0, 2, 1), lower.node(1, 1, 1), lower.node(2, 1, 0), lower.node(3, 0, 0),
                                  lower.node(4, 2, 0)}),
                solid_directions({upper.node(4, 0, 1), upper.node(4, 2, 1), upper.node(3, 1, 0), upper.node(2, 1, 1), upper.node(1, 0, 1),
                                  upper.node(0, 2, 1)}));
}

std::vector<Spring> bolt_springs() {
  const std::vector<frf::Dof> below = solid_directions(bolts_below), above = solid_directions(bolts_above);
  std::vector<Spring> springs;
  for (std::size_t i = 0; i < below.size(); ++i) springs.push_back({below[i], above[i]});
  return springs;
}

/// Bolts are tightened differently: 1, 0.85, 1.2 and 0.7 times 1e8 (x), 1.1e8 (y) and 2e8 N/m (z, along the bolt).
std::vector<double> bolt_stiffnesses() {
  std::vector<double> values;
  for (const double bolt : {1.0, 0.85, 1.2, 0.7}) {
    for (const double direction : {1.0e8, 1.1e8, 2.0e8}) values.push_back(bolt * direction);
  }
  return values;
}

/// Loss factors 0.10, 0.08 and 0.06 along x, y and z.
std::vector<double> bolt_dampings() {
  std::vector<double> values = bolt_stiffnesses();
  constexpr std::array<double, 3> loss_factor = {0.10, 0.08, 0.06};
  for (std::size_t i = 0; i < values.size(); ++i) values[i] *= loss_factor[i % 3];
  return values;
}

Case bolted(const std::string& name, const std::string& description, double level) {
  static const std::vector<Structure> blocks = {damped_block(lower), damped_block(upper)};
  static const std::vector<JointMatrix> joint = {
      springs(Kind::stiffness, bolt_dofs(), bolt_springs(), bolt_stiffnesses()),
      springs(Kind::hysteretic_damping, bolt_dofs(), bolt_springs(), bolt_dampings())};
  static const Structure both = assembled(blocks, bolt_dofs(), joint);
  Case definition;
  definition.name = name;
  definition.description = description;
  definition.substructures = blocks;
  definition.joint_dofs = bolt_dofs();
  definition.joint = joint;
  definition.assembly = both;
  definition.coupled_by_springs = true;
  definition.measured_substructures = joined(bolt_dofs(), other_dofs());
  definition.measured_assembly = definition.measured_substructures;
  definition.axis = {.start_hz = 200.0, .step_hz = 40.0, .lines = 157};
  definition.equations = {"nn", "nj", "jj"};
  definition.noise = frf::NoiseModel{.kind = frf::NoiseKind::circular, .level = level, .floor = 0.1 * level};
  definition.quantity = frf::Quantity::accelerance;
  return definition;
}

}  // namespace

std::vector<Case> cases_of_bolts() {
  return {bolted("bolts", "two solid blocks on four bolts of three springs each, 24 joint and 36 other coordinates, 1 % noise", 0.01),
          bolted("bolts-5", "bolts with 5 % noise", 0.05)};
}

}  // namespace jointid::problems
