#include "problems/case/thesis_beams.hpp"

namespace jointid::problems {
namespace {

constexpr double element_length = 0.3;
constexpr double loss_factor = 0.001;

Structure damped(Structure structure) {
  structure.add_proportional_damping(loss_factor);
  return structure;
}

}  // namespace

BeamSection thesis_section() {
  return {.width = 0.05, .thickness = 0.012, .youngs_modulus = 2.07e11, .density = 7547.0};
}

Structure substructure_a() {
  return damped(beam(thesis_section(), {.first_node = 1, .x = {0.0, 0.3, 0.6, 0.9}}));
}

Structure substructure_b(double mass_factor) {
  BeamSection section = thesis_section();
  section.density *= mass_factor;
  return damped(beam(section, {.first_node = 5, .x = {1.2, 1.5, 1.8}}));
}

std::vector<frf::Dof> thesis_joint_dofs() { return coordinates({7, 8, 9, 10}); }

Matrix joint_stiffness() { return element_stiffness(thesis_section(), element_length); }
Matrix joint_mass() { return element_mass(thesis_section(), element_length); }

std::vector<frf::Dof> coordinates(const std::vector<int>& numbers) {
  std::vector<frf::Dof> result;
  for (const int number : numbers) {
    result.push_back(
        {.node = (number + 1) / 2, .direction = number % 2 == 1 ? frf::Direction::y : frf::Direction::rz});
  }
  return result;
}

Case basic_case(const std::string& name, const std::string& description) {
  Case definition;
  definition.name = name;
  definition.description = description;
  definition.substructures = {substructure_a(), substructure_b()};
  definition.joint_dofs = thesis_joint_dofs();
  definition.axis = {.start_hz = 400.0, .step_hz = 20.0, .lines = 31};
  definition.equations = {"nn", "nj"};
  definition.weighting = "WA";
  set_joint(definition, {symmetric(Kind::stiffness, joint_stiffness()),
                         symmetric(Kind::hysteretic_damping, scaled(joint_stiffness(), loss_factor))});
  return definition;
}

void set_joint(Case& definition, std::vector<JointMatrix> joint) {
  definition.joint = std::move(joint);
  definition.assembly = assembled(definition.substructures, definition.joint_dofs, definition.joint);
}

}  // namespace jointid::problems
