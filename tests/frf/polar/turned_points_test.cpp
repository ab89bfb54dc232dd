#include "frf/noise/turned_points.hpp"

#include <gmock/gmock.h>

namespace jointid::frf {
namespace {

FrfHeader header(const char* response) {
  FrfHeader out;
  out.frequency_hz = {10.0, 20.0};
  out.response = {Dof::parse("2:+Z"), Dof::parse(response)};
  out.reference = {Dof::parse("1:+Z")};
  return out;
}

std::vector<Dof> found(const FrfHeader& of, double imaginary) {
  TurnedPoints points(of);
  const std::vector<Complex> values = {{1.0, 5.0}, {2.0, imaginary}, {1.0, -5.0}, {-2.0, imaginary}};
  points.add(values);
  return points.found();
}

TEST(TurnedPoints, AreDrivingPointsWhoseReceptanceHasAPositiveImaginaryPart) {
  EXPECT_THAT(names(found(header("1:+Z"), 0.1)), testing::ElementsAre("1:+Z"));
  EXPECT_TRUE(found(header("1:+Z"), -0.1).empty());
  EXPECT_THAT(names(found(header("1:-Z"), -0.1)), testing::ElementsAre("1:-Z"));
  EXPECT_TRUE(found(header("3:+Z"), 0.1).empty()) << "no driving point";
  EXPECT_TRUE(found(header("1:+Z"), 0.0).empty()) << "no damping";
  EXPECT_THAT(turned_points_text(found(header("1:+Z"), 0.1)), testing::HasSubstr("The driving point 1:+Z is not passive"));
  EXPECT_EQ(turned_points_text({}), "");
}

}  // namespace
}  // namespace jointid::frf
