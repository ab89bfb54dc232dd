#include "frf/set/quantity.hpp"

#include <gmock/gmock.h>

#include "file_fixture.hpp"

namespace jointid::frf {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string refusal(const std::string& word) {
  return message_of([&] { parse_quantity(word); });
}

TEST(QuantityWord, WordsOfTheFieldAreRead) {
  for (const char* word :
       {"receptance", "Receptance", "dynamic compliance", "Dynamic Flexibility", "dynamic_compliance", "displacement/force"}) {
    EXPECT_EQ(parse_quantity(word), Quantity::receptance) << word;
  }
  for (const char* word : {"mobility", "MOBILITY", "velocity/force"}) EXPECT_EQ(parse_quantity(word), Quantity::mobility) << word;
  for (const char* word : {"accelerance", "Accelerance", " inertance", "Inertance", "acceleration/force"}) {
    EXPECT_EQ(parse_quantity(word), Quantity::accelerance) << word;
  }
}

TEST(QuantityWord, AWordThatLeavesItOpenIsAskedAbout) {
  for (const char* word : {"compliance", "Admittance", "flexibility"}) {
    EXPECT_THAT(refusal(word), AllOf(HasSubstr("'" + std::string(word) + "'"),
                                     HasSubstr("write receptance for displacement over force, mobility for"),
                                     ::testing::Not(HasSubstr("did you mean"))));
  }
}

TEST(QuantityWord, ForceOverMotionIsSaidToBeThat) {
  EXPECT_THAT(refusal("impedance"), HasSubstr("is force over velocity, the inverse of a matrix of mobilities; export motion over force"));
  EXPECT_THAT(refusal("dynamic stiffness"), HasSubstr("is force over displacement"));
  EXPECT_THAT(refusal("Apparent Mass"), HasSubstr("is force over acceleration"));
}

TEST(QuantityWord, ASlipHasItsNeighbour) {
  EXPECT_THAT(refusal("acelerance"), HasSubstr("did you mean accelerance?"));
  EXPECT_THAT(refusal("volts"), HasSubstr("write receptance, mobility or accelerance"));
  EXPECT_EQ(parse_quantity("compliance", Quantity::receptance), Quantity::receptance);
  EXPECT_EQ(parse_quantity("mobility", Quantity::receptance), Quantity::mobility);
}

}  // namespace
}  // namespace jointid::frf
