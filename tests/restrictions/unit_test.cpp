#include "restrictions/unit.hpp"

#include <gmock/gmock.h>

#include "tests/restrictions/joints.hpp"

namespace jointid::restrictions {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> units_of(Kind kind, Pattern pattern) {
  return units(build({joint(dofs({"4:+Y", "4:+RZ"}), kind, pattern)}));
}

TEST(Unit, IsForceOverMotion) {
  EXPECT_THAT(units_of(Kind::stiffness, Pattern::full), ElementsAre("N/m", "N/rad", "N", "N*m/rad"));
  EXPECT_THAT(units_of(Kind::hysteretic_damping, Pattern::full), ElementsAre("N/m", "N/rad", "N", "N*m/rad"));
  EXPECT_THAT(units_of(Kind::viscous_damping, Pattern::full), ElementsAre("N*s/m", "N*s/rad", "N*s", "N*m*s/rad"));
  EXPECT_THAT(units_of(Kind::mass, Pattern::full), ElementsAre("kg", "kg*m", "kg*m", "kg*m^2"));
}

TEST(Unit, TheRadianDoesNotMakeUnitsDiffer) {
  EXPECT_THAT(units_of(Kind::stiffness, Pattern::symmetric), ElementsAre("N/m", "N/rad", "N*m/rad"));
}

TEST(Unit, OneUnknownAtSeveralUnitsIsMixed) {
  const EntryMatrix form = {{"a", "b"}, {"b", "a"}};
  EXPECT_THAT(units(build({joint(dofs({"4:+Y", "4:+RZ"}), Kind::stiffness, form)})), ElementsAre("mixed", "N/rad"));
}

TEST(Unit, MixedStaysMixed) {
  const EntryMatrix form = {{"a", "a"}, {"a", "a"}};
  EXPECT_THAT(units(build({joint(dofs({"4:+Y", "4:+RZ"}), Kind::stiffness, form)})), ElementsAre("mixed"));
}

}  // namespace
}  // namespace jointid::restrictions
