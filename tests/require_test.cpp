#include "tests/require.hpp"

#include <gtest/gtest-spi.h>

#include <array>
#include <cstdlib>
#include <optional>
#include <string>

namespace jointid {
namespace {

constexpr const char* variable = "JOINTID_REQUIRE_ALL";

/// JOINTID_REQUIRE_ALL with another value; it gets its own again with the end of the object.
class Setting {
 public:
  explicit Setting(const char* value) {
    if (const char* before = std::getenv(variable)) before_ = before;
    set(value);
  }
  ~Setting() { set(before_ ? before_->c_str() : nullptr); }
  Setting(const Setting&) = delete;
  Setting& operator=(const Setting&) = delete;

 private:
  static void set(const char* value) { value == nullptr ? ::unsetenv(variable) : ::setenv(variable, value, 1); }

  std::optional<std::string> before_;
};

void lack(int number, bool& went_on) {
  JOINTID_SKIP("there is no number " << number);
  went_on = true;
}

/// How a test ends that lacks something, with the variable at a value or unset.
testing::TestPartResult ended_with(const char* value) {
  const Setting setting(value);
  testing::TestPartResultArray results;
  bool went_on = false;
  {
    const testing::ScopedFakeTestPartResultReporter reporter(
        testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    lack(7, went_on);
  }
  EXPECT_FALSE(went_on);
  EXPECT_EQ(results.size(), 1);
  return results.GetTestPartResult(0);
}

TEST(Require, WhatIsMissingIsSkippedWithItsReason) {
  for (const char* value : std::array<const char*, 3>{nullptr, "", "0"}) {
    const testing::TestPartResult result = ended_with(value);
    EXPECT_TRUE(result.skipped());
    EXPECT_NE(std::string(result.message()).find("there is no number 7"), std::string::npos) << result.message();
  }
}

TEST(Require, WhereAllIsRequiredItFailsWithItsReason) {
  const testing::TestPartResult result = ended_with("1");
  EXPECT_TRUE(result.fatally_failed());
  EXPECT_NE(std::string(result.message()).find("there is no number 7"), std::string::npos) << result.message();
}

}  // namespace
}  // namespace jointid
