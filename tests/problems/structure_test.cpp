#include "problems/structure/structure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/complex.hpp"
#include "base/error.hpp"
#include "problems/case/thesis_beams.hpp"
#include "problems/structure/response.hpp"

namespace jointid::problems {
namespace {

using frf::Dof;

/// Half a unit of the ninth digit after the point: all digits of the worked values.
void expect_printed(Complex value, double real, double imag) {
  EXPECT_NEAR(value.real(), real, 0.5e-9 * std::pow(10.0, std::floor(std::log10(std::abs(real)))));
  EXPECT_NEAR(value.imag(), imag, 0.5e-9 * std::pow(10.0, std::floor(std::log10(std::abs(imag)))));
}

Complex receptance(const Structure& structure, const char* response, const char* reference,
                   double frequency_hz) {
  return frequency_response(structure, {.response = {Dof::parse(response)},
                                        .reference = {Dof::parse(reference)},
                                        .frequency_hz = {frequency_hz}})
      .values[0];
}

TEST(Structure, WorkedReceptancesOfSubstructureAndAssembly) {
  const Case a1 = basic_case("A1", "");
  expect_printed(receptance(a1.substructures[0], "1:+Y", "1:+Y", 455.0), 6.518350247e-7, -8.224326056e-9);
  expect_printed(receptance(a1.assembly, "4:+Y", "5:+Y", 455.0), 2.139319651e-8, -2.722344585e-10);
}

TEST(Structure, ElementMatricesAreThoseOfTheThesis) {
  const Matrix k = joint_stiffness();
  EXPECT_NEAR(k[0][0], 662400.0, 1e-6);
  EXPECT_NEAR(k[0][1], 99360.0, 1e-7);
  EXPECT_NEAR(k[1][1], 19872.0, 1e-7);
  EXPECT_NEAR(k[1][3], 9936.0, 1e-7);
  const Matrix m = joint_mass();
  EXPECT_NEAR(m[0][0], 0.50457086, 1e-8);
  EXPECT_NEAR(m[1][3], -0.0008732957142857145, 1e-15);
}

TEST(Structure, ASingleMassSpringDamperHasItsReceptance) {
  Structure oscillator({{.id = 1}}, {Dof::parse("1:+Y")});
  const restrictions::Spring ground{.first = Dof::parse("1:+Y"), .second = {}};
  oscillator.add(Kind::stiffness, ground, 1000.0);
  oscillator.add(Kind::mass, ground, 2.0);
  oscillator.add(Kind::viscous_damping, ground, 3.0);
  oscillator.add(Kind::hysteretic_damping, ground, 40.0);
  const double omega = 2.0 * std::numbers::pi * 5.0;
  const Complex expected = 1.0 / Complex(1000.0 - 2.0 * omega * omega, 3.0 * omega + 40.0);
  EXPECT_NEAR(std::abs(receptance(oscillator, "1:+Y", "1:+Y", 5.0) - expected), 0.0,
              1e-12 * std::abs(expected));
  EXPECT_EQ(receptance(oscillator, "1:-Y", "1:+Y", 5.0), -receptance(oscillator, "1:+Y", "1:+Y", 5.0));
}

TEST(Structure, TheExponentialWindowMovesPoles) {
  Structure oscillator({{.id = 1}}, {Dof::parse("1:+Y")});
  const restrictions::Spring ground{.first = Dof::parse("1:+Y"), .second = {}};
  oscillator.add(Kind::stiffness, ground, 1000.0);
  oscillator.add(Kind::mass, ground, 2.0);
  const double omega = 2.0 * std::numbers::pi * 5.0;
  const Complex s(7.0, omega);
  const Complex h = frequency_response(oscillator, {.response = {Dof::parse("1:+Y")},
                                                    .reference = {Dof::parse("1:+Y")},
                                                    .frequency_hz = {5.0},
                                                    .window_rate = 7.0})
                        .values[0];
  EXPECT_NEAR(std::abs(h * (1000.0 + 2.0 * s * s) - 1.0), 0.0, 1e-12);
}

/// A spring of 1e6 times the stiffness of the beam is as good as a rigid connection to 1e-6 or so.
TEST(Structure, TyingIsTheLimitOfAHardSpring) {
  const Structure both = merged(substructure_a(), substructure_b());
  Structure hard = both;
  hard.add(Kind::stiffness, {.first = Dof::parse("4:+RZ"), .second = Dof::parse("5:+RZ")}, 1e11);
  const Structure rigid = tied(both, Dof::parse("4:+RZ"), Dof::parse("5:+RZ"));
  EXPECT_EQ(rigid.size(), 13U);
  for (const char* dof : {"1:+Y", "4:+RZ", "5:+Y", "7:+RZ"}) {
    const Complex expected = receptance(rigid, dof, "2:+Y", 333.0);
    EXPECT_NEAR(std::abs(receptance(hard, dof, "2:+Y", 333.0) - expected), 0.0, 1e-5 * std::abs(expected))
        << dof;
  }
}

TEST(Structure, AnAddedMassIsWhatTheAccelerometerFormulaPredicts) {
  const Structure part = substructure_a();
  const std::vector<Dof> dofs = {Dof::parse("1:+Y"), Dof::parse("3:+Y")};
  const ResponseRequest request{
      .response = dofs, .reference = dofs, .frequency_hz = {100.0, 481.0}, .window_rate = 4.0};
  const frf::FrfSet loaded = with_accelerometer(frequency_response(part, request), 0.05, 4.0);
  for (std::size_t r = 0; r < 2; ++r) {
    Structure heavy = part;
    heavy.add(Kind::mass, {.first = dofs[r], .second = {}}, 0.05);
    const frf::FrfSet expected = frequency_response(heavy, request);
    for (std::size_t line = 0; line < 2; ++line) {
      for (std::size_t c = 0; c < 2; ++c) {
        const std::size_t i = loaded.index(line, r, c);
        EXPECT_NEAR(std::abs(loaded.values[i] - expected.values[i]), 0.0,
                    1e-10 * std::abs(expected.values[i]));
      }
    }
  }
}

TEST(Structure, UnknownAndDoubledDofsAreErrors) {
  EXPECT_THROW(substructure_a().index(Dof::parse("9:+Y")), InputError);
  EXPECT_THROW(merged(substructure_a(), substructure_a()), InputError);
}

}  // namespace
}  // namespace jointid::problems
