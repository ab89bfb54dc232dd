#include "problems/case/catalogue.hpp"
#include "problems/case/thesis_beams.hpp"

namespace jointid::problems {
namespace {

Case with_axis(Case definition, const Axis& axis) {
  definition.axis = axis;
  return definition;
}

/// Only these non-joint coordinates, and the joint's.
Case with_coordinates(Case definition, std::vector<int> numbers) {
  numbers.insert(numbers.end(), {7, 8, 9, 10});
  definition.measured_substructures = coordinates(numbers);
  definition.measured_assembly = definition.measured_substructures;
  return definition;
}

/// Table 6.2, T10-4: the form of a symmetric beam element, four unknowns per matrix.
JointMatrix four_letters(const JointMatrix& matrix) {
  const Matrix& x = matrix.truth;
  return expressed(
      matrix.kind, x,
      {{"a", "b", "-a", "b"}, {"b", "c", "-b", "d"}, {"-a", "-b", "a", "-b"}, {"b", "d", "-b", "c"}},
      {{"a", x[0][0]}, {"b", x[0][1]}, {"c", x[1][1]}, {"d", x[1][3]}});
}

/// Table 6.2, T10-2: as T10-4 with b and d known; `b` and `d` as printed there.
JointMatrix two_letters(const JointMatrix& matrix, double b, double d) {
  const Matrix& x = matrix.truth;
  return expressed(matrix.kind, x, {{"a", b, "-a", b}, {b, "c", -b, d}, {"-a", -b, "a", -b}, {b, d, -b, "c"}},
                   {{"a", x[0][0]}, {"c", x[1][1]}});
}

Case unweighted() {
  Case definition = basic_case("A2", "A1 without weighting (§6.6.2)");
  definition.weighting = "none";
  return definition;
}

Case four_unknowns_each() {
  Case definition = basic_case("A9", "A1 with restriction T10-4: four unknowns in K and in D (§6.6.2)");
  set_joint(definition, {four_letters(definition.joint[0]), four_letters(definition.joint[1])});
  return definition;
}

Case two_unknowns_each() {
  Case definition = basic_case("A10", "A1 with restriction T10-2: two unknowns in K and in D (§6.6.2)");
  set_joint(definition, {two_letters(definition.joint[0], 99360.0, 9936.0),
                         two_letters(definition.joint[1], 99.36, 9.936)});
  return definition;
}

Case by_method_two() {
  Case definition = basic_case("A11", "A1 by method two, equation (6.22) only (§6.6.2)");
  definition.method = "two";
  definition.equations = {"jn"};
  return definition;
}

}  // namespace

std::vector<Case> cases_of_basic_study() {
  return {
      basic_case("A1", "reference: two beams joined by a beam element without mass, 31 lines (§6.6.2)"),
      unweighted(),
      with_axis(basic_case("A3", "A1 in the narrow range 400-405 Hz, 101 lines (§6.6.2)"),
                {400.0, 0.05, 101}),
      with_axis(basic_case("A4", "A1 in the range 400-450 Hz, 101 lines (§6.6.2)"), {400.0, 0.5, 101}),
      with_axis(basic_case("A5", "A1 with 121 lines, 5 Hz steps (§6.6.2)"), {400.0, 5.0, 121}),
      with_axis(basic_case("A6", "A1 with 301 lines, 2 Hz steps (§6.6.2)"), {400.0, 2.0, 301}),
      with_coordinates(basic_case("A7", "A1 with non-joint coordinates 1, 3, 5, 11, 13 only (§6.6.2)"),
                       {1, 3, 5, 11, 13}),
      with_coordinates(basic_case("A8", "A1 with non-joint coordinates 1 and 13 only (§6.6.2)"), {1, 13}),
      four_unknowns_each(),
      two_unknowns_each(),
      by_method_two(),
  };
}

}  // namespace jointid::problems
