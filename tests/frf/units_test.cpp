#include "frf/set/units.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "file_fixture.hpp"
#include "frf/set/line_scale.hpp"

namespace jointid::frf {
namespace {

TEST(Units, LabelsOfEveryQuantityInManySpellings) {
  const double g = 9.80665;
  EXPECT_DOUBLE_EQ(si_factor("m/N", Quantity::receptance), 1.0);
  EXPECT_DOUBLE_EQ(si_factor("mm/N", Quantity::receptance), 1e-3);
  EXPECT_DOUBLE_EQ(si_factor("µm/N", Quantity::receptance), 1e-6);
  EXPECT_DOUBLE_EQ(si_factor("mm/kN", Quantity::receptance), 1e-6);
  EXPECT_DOUBLE_EQ(si_factor("in/lbf", Quantity::receptance), 0.0254 / 4.4482216152605);
  EXPECT_DOUBLE_EQ(si_factor("rad/(N*m)", Quantity::receptance), 1.0);
  EXPECT_DOUBLE_EQ(si_factor("rad/N/mm", Quantity::receptance), 1e3);
  EXPECT_DOUBLE_EQ(si_factor("mm/s/N", Quantity::mobility), 1e-3);
  EXPECT_DOUBLE_EQ(si_factor("s/kg", Quantity::mobility), 1.0);
  EXPECT_DOUBLE_EQ(si_factor("g/N", Quantity::accelerance), g);
  EXPECT_DOUBLE_EQ(si_factor("g/lbf", Quantity::accelerance), g / 4.4482216152605);
  EXPECT_DOUBLE_EQ(si_factor("1/kg", Quantity::accelerance), 1.0);
  for (const char* label : {"mm/s^2/N", "(mm/s^2)/N", "mm/(s^2*N)", "mm/s2/N", "mm/s²/N", "mm·s⁻²·N⁻¹",
                            "mm.s^-2.N^-1", "mm / s^2 / N"}) {
    EXPECT_DOUBLE_EQ(si_factor(label, Quantity::accelerance), 1e-3) << label;
  }
}

TEST(Units, TheLabelsThatTheWriterUsesAreSi) {
  for (const Quantity quantity : all_quantities) EXPECT_EQ(si_factor(unit(quantity), quantity), 1.0);
}

TEST(Units, WhatIsNoUnitIsAnErrorThatNamesIt) {
  for (const std::string label : {"", "V/N", "m//N", "m/N)", "(m/N", "m^/N", "m^99/N", "m 2/N", "2*m/N"}) {
    const std::string message = message_of([&] { si_factor(label, Quantity::receptance); });
    EXPECT_NE(message.find("unknown unit '" + label + "'"), std::string::npos) << message;
  }
  EXPECT_NE(
      message_of([] { si_factor(std::string(5000, '('), Quantity::receptance); }).find("unknown unit '((("),
      std::string::npos);
}

TEST(Units, AUnitOfAnotherQuantityIsAnError) {
  const std::string message = message_of([] { si_factor("m/N", Quantity::accelerance); });
  EXPECT_NE(message.find("unit 'm/N' is not a unit of accelerance; write m/(s^2*N)"), std::string::npos)
      << message;
  const std::string product = message_of([] { si_factor("m N", Quantity::receptance); });
  EXPECT_NE(product.find("unit 'm N' is not a unit of receptance"), std::string::npos) << product;
}

TEST(Units, OfRotationsAreNotOfTranslations) {
  FrfHeader header;
  header.quantity = Quantity::receptance;
  header.response = header.reference = dofs({"1:+X"});
  for (const char* label : {"1/lb", "1/N", "rad/N", "m/(N*m)", "deg/N"})
    EXPECT_NE(message_of([&] { si_factor(label, header); }).find("is of a rotation or a moment, and all DOFs are translations"),
              std::string::npos)
        << label;
  EXPECT_DOUBLE_EQ(si_factor("mm/N", header), 1e-3);
  header.response = dofs({"1:+RX"});
  EXPECT_DOUBLE_EQ(si_factor("rad/N", header), 1.0);
}

TEST(Units, OfFrfsAreMotionsOverForces) {
  for (const char* label : {"m/N", "mm/s/N", "g/lbf", "rad/(N*m)", "1/kg"}) EXPECT_NO_THROW(require_frf_unit(label)) << label;
  EXPECT_NE(message_of([] { require_frf_unit("g"); }).find("unit 'g' is no motion over a force; write"), std::string::npos);
  EXPECT_NE(message_of([] { require_frf_unit("V/N"); }).find("V is a voltage"), std::string::npos);
}

TEST(Units, ALabelOfTranslationsDoesNotScaleRotations) {
  FrfHeader header;
  header.response = dofs({"1:+Y", "1:+RZ"});
  header.reference = dofs({"1:+Y"});
  EXPECT_EQ(si_factor("m/N", header), 1.0);
  const std::string message = message_of([&] { si_factor("mm/N", header); });
  EXPECT_NE(message.find("unit 'mm/N' does not define the scale of rotations"), std::string::npos) << message;
  header.response = dofs({"1:+Y"});
  EXPECT_EQ(si_factor("mm/N", header), 1e-3);
}

TEST(LineScale, FollowsTheComplexFactor) {
  const double f = 37.0;
  const double omega = 2.0 * std::numbers::pi * f;
  const Complex h{3.0, -2.0};
  const Complex i{0.0, 1.0};
  const auto scaled = [&](Quantity quantity) { return LineScale::to_receptance(quantity, 1e-3, f).value(h); };
  EXPECT_TRUE(near(scaled(Quantity::receptance), 1e-3 * h, 1e-15));
  EXPECT_TRUE(near(scaled(Quantity::mobility), 1e-3 * h / (i * omega), 1e-15));
  EXPECT_TRUE(near(scaled(Quantity::accelerance), -1e-3 * h / (omega * omega), 1e-15));
}

TEST(LineScale, MobilitySwapsTheVariancesOfRealAndImaginaryPart) {
  const double omega = 2.0 * std::numbers::pi * 10.0;
  const Complex v{4.0, 9.0};
  const Complex of_mobility = LineScale::to_receptance(Quantity::mobility, 1.0, 10.0).variance(v);
  EXPECT_DOUBLE_EQ(of_mobility.real(), 9.0 / (omega * omega));
  EXPECT_DOUBLE_EQ(of_mobility.imag(), 4.0 / (omega * omega));
  const Complex of_accelerance = LineScale::to_receptance(Quantity::accelerance, 1.0, 10.0).variance(v);
  EXPECT_DOUBLE_EQ(of_accelerance.real(), 4.0 / std::pow(omega, 4));
  EXPECT_DOUBLE_EQ(of_accelerance.imag(), 9.0 / std::pow(omega, 4));
}

TEST(LineScale, At0HzOnlyReceptanceIsKnown) {
  EXPECT_TRUE(LineScale::to_receptance(Quantity::receptance, 1.0, 0.0).is_identity());
  for (const Quantity quantity : {Quantity::mobility, Quantity::accelerance}) {
    EXPECT_TRUE(std::isnan(LineScale::to_receptance(quantity, 1.0, 0.0).value({1.0, 1.0}).real()));
  }
}

}  // namespace
}  // namespace jointid::frf
