#include "problems/case/catalogue.hpp"
#include "problems/case/thesis_beams.hpp"

namespace jointid::problems {
namespace {

constexpr double translational = 662400.0;  ///< N/m, between coordinates 7 and 9
constexpr double rotational = 2e5;  ///< N·m/rad, between coordinates 8 and 10; the print's 1987.2 is not hard

constexpr double rigid = 2e7;       ///< N·m/rad, which the rotary elements of Table 6.18 (a few 1e-4 of the truth) would need

Matrix spring(double k) { return {{k, -k}, {-k, k}}; }

Matrix both_springs(double r = rotational) {
  const double t = translational;
  return {{t, -t, 0.0, 0.0}, {-t, t, 0.0, 0.0}, {0.0, 0.0, r, -r}, {0.0, 0.0, -r, r}};
}

/// Joint DOFs 7, 9, 8, 10 as in the thesis, 100–500 Hz.
Case springs_case(const std::string& name, const std::string& description, const JointMatrix& stiffness,
                  bool exclude_resonances) {
  Case definition = basic_case(name, description);
  definition.axis = {.start_hz = 100.0, .step_hz = 20.0, .lines = 21};
  definition.weighting = "WB";
  definition.joint_dofs = coordinates({7, 9, 8, 10});
  definition.exclude_resonances = exclude_resonances;
  set_joint(definition, {stiffness});
  return definition;
}

JointMatrix six_unknowns(double r = rotational) {
  const double t = translational;
  return expressed(
      Kind::stiffness, both_springs(r),
      {{"x1", "x2", 0.0, 0.0}, {"x2", "x3", 0.0, 0.0}, {0.0, 0.0, "x4", "x5"}, {0.0, 0.0, "x5", "x6"}},
      {{"x1", t}, {"x2", -t}, {"x3", t}, {"x4", r}, {"x5", -r}, {"x6", r}});
}

JointMatrix two_unknowns() {
  return expressed(
      Kind::stiffness, both_springs(),
      {{"x1", "-x1", 0.0, 0.0}, {"-x1", "x1", 0.0, 0.0}, {0.0, 0.0, "x4", "-x4"}, {0.0, 0.0, "-x4", "x4"}},
      {{"x1", translational}, {"x4", rotational}});
}

/// Rotations 8 and 10 rigidly coupled before: one substructure, and the joint is the translational spring.
/// The stiff joint's own coordinates are left out of both files, as thesis §6.9.1 says for a rigid joint without
/// mass.
Case coupled_case(const std::string& name, const std::string& description, bool exclude_resonances) {
  Case definition = springs_case(name, description, six_unknowns(), exclude_resonances);
  const frf::Dof kept = coordinates({8})[0];
  const frf::Dof removed = coordinates({10})[0];
  definition.substructures = {tied(merged(substructure_a(), substructure_b()), kept, removed)};
  definition.joint_dofs = coordinates({7, 9});
  definition.joint = {expressed(Kind::stiffness, spring(translational), {{"x1", "x2"}, {"x2", "x3"}},
                                {{"x1", translational}, {"x2", -translational}, {"x3", translational}})};
  definition.measured_substructures = coordinates({1, 2, 3, 4, 5, 6, 7, 9, 11, 12, 13, 14});
  definition.measured_assembly = definition.measured_substructures;
  return definition;
}

}  // namespace

std::vector<Case> cases_of_hard_joints() {
  return {
      springs_case("G1", "a translational and a hard rotary spring (2e5 N*m/rad), six unknowns (§6.9.2)",
                   six_unknowns(), false),
      springs_case("G2", "G1 without the lines at resonances (§6.9.2)", six_unknowns(), true),
      springs_case("G3", "G2 with two unknowns (§6.9.2)", two_unknowns(), true),
      coupled_case("G4", "G1 with the rotations rigidly coupled beforehand, three unknowns (§6.9.2)", false),
      coupled_case("G5", "G4 without the lines at resonances (§6.9.2)", true),
      springs_case("G6", "G1 with a rotary spring of 2e7 N*m/rad, which cannot be identified (§6.9.2)", six_unknowns(rigid), false),
  };
}

}  // namespace jointid::problems
