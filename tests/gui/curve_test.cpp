#include "gui/plot/curve.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace jointid::gui {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Curve curve(const char* response = "1:+X", const char* reference = "2:+X") {
  Curve made;
  made.name = "a, b";
  made.response = frf::Dof::parse(response);
  made.reference = frf::Dof::parse(reference);
  made.frequency_hz = {1.0, 2.0, 4.0};
  made.values = {{1.0, 0.0}, {0.0, 2.0}, {std::nan(""), std::nan("")}};
  return made;
}

TEST(Panels, MagnitudeIsLogarithmicAndPhaseInDegrees) {
  const auto all = panels({curve()}, View::magnitude_phase, frf::Quantity::receptance);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_TRUE(all[0].logarithmic);
  EXPECT_EQ(all[0].label, "receptance (m/N)");
  EXPECT_EQ(all[0].ordinates[0][1], 2.0);
  EXPECT_THAT(all[1].ordinates[0][1], DoubleNear(90.0, 1e-12));
  EXPECT_TRUE(std::isnan(all[0].ordinates[0][2]));
}

TEST(Panels, PhasesAreNotCutWhereTheyStay) {
  Curve noisy = curve();
  noisy.values = {{-1.0, 0.01}, {-1.0, -0.01}, {-1.0, 0.01}};
  const auto all = panels({noisy}, View::magnitude_phase, frf::Quantity::receptance);
  EXPECT_NEAR(all[1].ordinates[0][0], all[1].ordinates[0][1], 5.0);
}

TEST(Panels, AccelerancesAreReceptancesTimesMinusOmegaSquared) {
  const auto all = panels({curve()}, View::real_imaginary, frf::Quantity::accelerance);
  const double omega = 2.0 * std::numbers::pi * 2.0;
  EXPECT_THAT(all[1].ordinates[0][1], DoubleNear(-2.0 * omega * omega, 1e-9));
  EXPECT_THAT(all[1].label, HasSubstr("m/s²/N"));
}

TEST(Panels, TheDifferenceIsInDecibelFromTheMeasuredOneBefore) {
  Curve computed = curve();
  computed.is_measured = false;
  for (Complex& value : computed.values) value *= 10.0;
  const auto all = panels({curve(), computed}, View::difference, frf::Quantity::receptance);
  ASSERT_EQ(all.size(), 1U);
  EXPECT_THAT(all[0].ordinates[0], IsEmpty());
  EXPECT_THAT(all[0].ordinates[1][0], DoubleNear(20.0, 1e-12));
  EXPECT_TRUE(std::isnan(all[0].ordinates[1][2]));
}

TEST(Units, AreThoseOfTheDofs) {
  EXPECT_EQ(unit_of({curve("1:+RX", "2:+X")}, frf::Quantity::mobility), "rad/s/N");
  EXPECT_EQ(unit_of({curve("1:+X", "2:+RX")}, frf::Quantity::receptance), "m/(N·m)");
  EXPECT_EQ(unit_of({curve(), curve("1:+RX")}, frf::Quantity::receptance), "SI");
}

TEST(NearestLine, IsTheNearest) {
  EXPECT_EQ(nearest_line(curve(), 0.0), 0U);
  EXPECT_EQ(nearest_line(curve(), 2.9), 1U);
  EXPECT_EQ(nearest_line(curve(), 3.1), 2U);
  EXPECT_EQ(nearest_line(curve(), 99.0), 2U);
}

TEST(Readout, HasValuesAndUnits) {
  EXPECT_EQ(readout({curve()}, 2.2, frf::Quantity::receptance), "2 Hz\na, b:  2 m/N ∠ 90.0°");
  EXPECT_THAT(readout({curve()}, 4.0, frf::Quantity::receptance), HasSubstr("not measured"));
  EXPECT_THAT(readout(std::vector<Curve>(9, curve()), 1.0, frf::Quantity::receptance), HasSubstr("3 more"));
}

TEST(CurvesTable, HasARowALineAndNothingForWhatIsNotThere) {
  EXPECT_EQ(curves_table({curve()}, frf::Quantity::receptance, ','),
            "frequency_hz,\"a, b real (m/N)\",\"a, b imag (m/N)\"\n1,1,0\n2,0,2\n4,,\n");
}

}  // namespace
}  // namespace jointid::gui
