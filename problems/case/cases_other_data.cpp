#include "problems/case/catalogue.hpp"
#include "problems/case/thesis_beams.hpp"

namespace jointid::problems {
namespace {

Case modal_errors(const std::string& name, const std::string& description, bool exclude_resonances) {
  Case definition = basic_case(name, description);
  definition.noise = ConsistentErrors{};
  definition.exclude_resonances = exclude_resonances;
  return definition;
}

/// Thesis §6.12.3: only H_nn of the assembly, joint without damping.
Case inaccessible_joint(const std::string& name, const std::string& description, const std::string& method,
                        const Axis& axis) {
  Case definition = basic_case(name, description);
  definition.axis = axis;
  definition.method = method;
  definition.equations.clear();
  definition.measured_assembly = coordinates({1, 2, 3, 4, 5, 6, 11, 12, 13, 14});
  set_joint(definition, {symmetric(Kind::stiffness, joint_stiffness())});
  return definition;
}

Case iterative() {
  Case definition = inaccessible_joint(
      "H4",
      "as H3, iteratively from a start 4.7 times too stiff, 5 Hz steps, resonances left out (Table 6.22)",
      "newton", {.start_hz = 400.0, .step_hz = 5.0, .lines = 121});
  const BeamSection start = {.width = 0.07, .thickness = 0.015, .youngs_modulus = 2.07e11, .density = 7547.0};
  definition.weighting.clear();
  definition.start_stiffness = element_stiffness(start, 0.25);
  definition.exclude_resonances = true;
  return definition;
}

}  // namespace

std::vector<Case> cases_of_other_data() {
  return {
      modal_errors("H1", "A1 with consistent errors: FRFs synthesised from wrong modes (§6.10)", false),
      modal_errors("H2", "H1 without the lines at resonances (§6.10)", true),
      inaccessible_joint("H3", "only H_nn of the assembly, direct solution (Table 6.20)", "direct",
                         {.start_hz = 400.0, .step_hz = 20.0, .lines = 31}),
      iterative(),
  };
}

}  // namespace jointid::problems
