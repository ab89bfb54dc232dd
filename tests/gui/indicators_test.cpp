#include "gui/plot/indicators.hpp"

#include <gmock/gmock.h>

#include "base/control.hpp"
#include "base/statistics.hpp"

namespace jointid::gui {
namespace {

using testing::HasSubstr;

Curve curve_in(const char* file, const char* response, const char* reference, std::vector<Complex> values) {
  Curve made;
  made.file = file;
  made.response = frf::Dof::parse(response);
  made.reference = frf::Dof::parse(reference);
  made.values = std::move(values);
  for (std::size_t i = 0; i < made.values.size(); ++i) made.frequency_hz.push_back(10.0 + static_cast<double>(i));
  return made;
}

TEST(Indicators, TheSumIsThatOfTheMagnitudesOfEachFile) {
  const auto found = indicators({curve_in("a", "1:+X", "1:+X", {Complex(3.0, 4.0), Complex(1.0, 0.0)}),
                                 curve_in("a", "2:+X", "1:+X", {Complex(0.0, -2.0), Complex(nan, nan)}),
                                 curve_in("b", "1:+X", "1:+X", {Complex(7.0, 0.0)})},
                                View::sum, {});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_THAT(found[0].values, testing::ElementsAre(Complex(7.0), Complex(1.0)));
  EXPECT_THAT(found[0].name, HasSubstr("2 FRFs"));
  EXPECT_THAT(found[1].values, testing::ElementsAre(Complex(7.0)));
}

/// Of the matrix [2 0; 0 i] the singular values are 2 and 1, whatever order its FRFs come in.
TEST(Indicators, CmifAreTheSingularValuesOfTheMatrixOfFrfs) {
  const auto found =
      indicators({curve_in("a", "2:+X", "2:+X", {Complex(0.0, 1.0)}), curve_in("a", "1:+X", "2:+X", {Complex(0.0)}),
                  curve_in("a", "1:+X", "1:+X", {Complex(2.0)}), curve_in("a", "2:+X", "1:+X", {Complex(0.0)})},
                 View::cmif, {});
  ASSERT_EQ(found.size(), 2U);
  EXPECT_NEAR(found[0].values[0].real(), 2.0, 1e-14);
  EXPECT_NEAR(found[1].values[0].real(), 1.0, 1e-14);
  EXPECT_FALSE(found[0].has_phase);
}

TEST(Indicators, RotationsAreNotMixedWithTranslations) {
  const auto found = indicators({curve_in("a", "1:+X", "1:+X", {Complex(3.0)}), curve_in("a", "1:+RZ", "1:+X", {Complex(100.0)})},
                                View::sum, {});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].values[0], Complex(3.0));
  EXPECT_THAT(found[0].name, HasSubstr("1 FRFs"));
}

TEST(Indicators, OtherViewsKeepTheCurvesAndAllCanBeStopped) {
  const std::vector<Curve> curves = {curve_in("a", "1:+X", "1:+X", {Complex(3.0)})};
  EXPECT_EQ(indicators(curves, View::nyquist, {}).front().values, curves.front().values);
  EXPECT_THROW(indicators(curves, View::cmif, [] { return true; }), Interrupted);
}

TEST(Indicators, AreReadOutWithoutAPhase) {
  const auto found = indicators({curve_in("a", "1:+X", "1:+X", {Complex(-3.0)})}, View::sum, {});
  EXPECT_THAT(readout(found, 10.0, frf::Quantity::receptance), testing::AllOf(HasSubstr("3 m/N"), testing::Not(HasSubstr("∠"))));
  EXPECT_THAT(panels(found, View::sum, frf::Quantity::accelerance).front().ordinates.front().front(),
              testing::DoubleNear(3.0 * 4.0 * 9.8696044010893586 * 100.0, 1e-9));
}

}  // namespace
}  // namespace jointid::gui
