#include "problems/case/catalogue.hpp"
#include "problems/case/thesis_beams.hpp"

namespace jointid::problems {
namespace {

/// Thesis §6.7.2.1: the form that the geometric symmetry of the joint leaves, six unknowns per matrix.
JointMatrix six_letters(Kind kind, const Matrix& x) {
  return expressed(
      kind, x, {{"a", "c", "e", "d"}, {"c", "b", "-d", "f"}, {"e", "-d", "a", "-c"}, {"d", "f", "-c", "b"}},
      {{"a", x[0][0]}, {"c", x[0][1]}, {"e", x[0][2]}, {"d", x[0][3]}, {"b", x[1][1]}, {"f", x[1][3]}});
}

}  // namespace

std::vector<Case> cases_of_refined_weighting() {
  Case b = basic_case("B", "joint with mass: K, M and D of a beam element, equation nn only (§6.7.2)");
  b.axis = {.start_hz = 100.0, .step_hz = 30.0, .lines = 31};
  b.equations = {"nn"};
  b.weighting = "WBS";
  b.delta = 0.05;
  set_joint(b, {six_letters(Kind::stiffness, joint_stiffness()), six_letters(Kind::mass, joint_mass()),
                six_letters(Kind::hysteretic_damping, scaled(joint_stiffness(), 0.001))});
  return {b};
}

}  // namespace jointid::problems
