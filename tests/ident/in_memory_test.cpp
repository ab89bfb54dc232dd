#include <gmock/gmock.h>

#include <functional>
#include <numbers>
#include <numeric>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"

namespace jointid {
namespace {

using frf::Dof;
using testing::HasSubstr;

constexpr double stiffness = 2.5e5, loss = 300.0, mass_1 = 2.0, mass_2 = 3.0;

const Dof dof_1 = Dof::parse("1:+X"), dof_2 = Dof::parse("2:+X");

/// Free masses, and both with a spring of complex stiffness between them.
Complex mass(double m, double omega) { return -1.0 / (omega * omega * m); }

std::vector<Complex> coupled(double omega) {
  const Complex z(stiffness, loss), a = z - omega * omega * mass_1, b = z - omega * omega * mass_2, det = a * b - z * z;
  return {b / det, z / det, z / det, a / det};
}

std::vector<double> lines() {
  std::vector<double> hz(20);
  std::iota(hz.begin(), hz.end(), 40.0);
  return hz;
}

frf::FrfSet set_of(const std::string& name, const std::vector<Dof>& dofs,
                   const std::function<std::vector<Complex>(double)>& frfs) {
  frf::FrfSet set;
  set.header.file = name;
  set.header.frequency_hz = lines();
  set.header.response = set.header.reference = dofs;
  for (const double hz : lines()) {
    for (const Complex& value : frfs(2.0 * std::numbers::pi * hz)) set.values.push_back(value);
  }
  return set;
}

std::vector<frf::FrfSet> parts() {
  return {set_of("part 1", {dof_1}, [](double omega) { return std::vector{mass(mass_1, omega)}; }),
          set_of("part 2", {dof_2}, [](double omega) { return std::vector{mass(mass_2, omega)}; })};
}

std::vector<frf::FrfSet> assembly() { return {set_of("assembly", {dof_1, dof_2}, coupled)}; }

/// Its files are not opened.
ident::Scene scene() {
  return ident::parse_scene(R"(
    [data]
    substructures = ["part 1", "part 2"]
    assembly = ["assembly"]
    [joint]
    dofs = ["1:+X", "2:+X"]
    stiffness.springs = [["1:+X", "2:+X"]]
    hysteretic_damping.springs = [["1:+X", "2:+X"]]
  )",
                            "in memory");
}

TEST(InMemory, TheSpringBetweenTwoMassesIsFound) {
  const auto plan = ident::make_plan(scene(), parts(), assembly());
  const auto solution = ident::solve(*plan);
  ASSERT_EQ(solution.unknowns.size(), 2U);
  EXPECT_NEAR(solution.unknowns[0].value, stiffness, 1e-9 * stiffness);
  EXPECT_NEAR(solution.unknowns[1].value, loss, 1e-9 * stiffness);
}

/// What make_plan() says of these sets, or empty.
std::string refusal(const std::vector<frf::FrfSet>& substructures) {
  try {
    ident::make_plan(scene(), substructures, assembly());
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(InMemory, WrongSizesAreAnErrorThatNamesTheSet) {
  EXPECT_EQ(refusal(parts()), "");
  auto short_by_one = parts();
  short_by_one[1].values.pop_back();
  EXPECT_THAT(refusal(short_by_one), HasSubstr("part 2: values: 19 numbers, where 20 lines × 1 responses × 1 references are 20"));
  auto too_many_variances = parts();
  too_many_variances[0].variance.assign(21, {1.0, 1.0});
  EXPECT_THAT(refusal(too_many_variances), HasSubstr("part 1: variance: 21 numbers"));
  auto short_axis = parts();
  short_axis[0].header.frequency_hz.pop_back();
  EXPECT_THAT(refusal(short_axis), HasSubstr("part 1: values: 20 numbers, where 19 lines"));
  auto twice = parts();
  twice[0].header.response = {dof_1, dof_1};
  EXPECT_THAT(refusal(twice), HasSubstr("part 1"));
}

}  // namespace
}  // namespace jointid
