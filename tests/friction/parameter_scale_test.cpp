#include "friction/path/parameter_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace jointid::friction {
namespace {

TEST(ParameterScale, GoesThereAndBackAndItsSlopeIsTheDerivative) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const std::vector<Parameter> parameters = {{"k", "", 3e7, 0.0, inf}, {"b", "", 2.5, 0.0, 700.0}, {"c", "", -4e13, -inf, 0.0},
                                             {"x", "", -0.4, -1.0, 0.0}, {"y", "", 7.0, -inf, inf}};
  for (const Parameter& parameter : parameters) {
    const ParameterScale scale(parameter);
    const double q = scale.free(parameter.value);
    EXPECT_NEAR(scale.value(q), parameter.value, 1e-13 * std::abs(parameter.value)) << parameter.name;
    const double difference = (scale.value(q + 1e-5) - scale.value(q - 1e-5)) / 2e-5;
    EXPECT_NEAR(scale.slope(q), difference, 1e-8 * std::abs(difference)) << parameter.name;
    for (const double far : {-30.0, 30.0}) {
      EXPECT_GE(scale.value(far), parameter.lower);
      EXPECT_LE(scale.value(far), parameter.upper);
    }
  }
}

TEST(ParameterScale, ABoundIsTakenALittleInside) {
  const ParameterScale scale({"b", "", 0.0, 0.0, 700.0, true});
  EXPECT_TRUE(std::isfinite(scale.free(0.0)));
  EXPECT_NEAR(scale.value(scale.free(0.0)), 0.0, 1e-6);
}

}  // namespace
}  // namespace jointid::friction
