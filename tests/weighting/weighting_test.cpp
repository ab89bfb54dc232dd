#include "weighting/weighting.hpp"

#include <gmock/gmock.h>

#include "base/error.hpp"

namespace jointid::weighting {
namespace {

using ::testing::HasSubstr;

TEST(Weighting, ParseIsTheInverseOfName) {
  for (const Weighting weighting :
       {Weighting::none, Weighting::wa, Weighting::wb, Weighting::wbg, Weighting::wbs}) {
    EXPECT_EQ(parse_weighting(name(weighting)), weighting);
  }
  EXPECT_EQ(name(Weighting::wbg), "WBG");
}

TEST(Weighting, AnUnknownNameIsAnErrorWithTheNearestWord) {
  for (const auto& [text, near] : {std::pair{"wbs", "did you mean WBS?"}, {"WBT", "did you mean WB?"},
                                   {"None", "did you mean none?"}, {"", "Use none"}, {"uniform weights", "Use none"}}) {
    try {
      parse_weighting(text);
      FAIL() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_THAT(error.what(), HasSubstr("'" + std::string(text) + "'"));
      EXPECT_THAT(error.what(), HasSubstr(near));
    }
  }
}

}  // namespace
}  // namespace jointid::weighting
