#include "base/status.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace jointid {
namespace {

/// Files of studies hold the numbers, JSON has the words: neither may change.
TEST(Status, WordsAndNumbersAreThoseOfFiles) {
  const std::vector<std::string> words = {"ok",          "rank_deficient", "no_equations",  "not_converged",
                                          "imprecise",   "doubtful",       "poor_fit",      "no_modes",
                                          "no_response", "too_few_data",   "too_few_points"};
  for (std::size_t i = 0; i < words.size(); ++i) EXPECT_EQ(name(static_cast<Status>(i)), words[i]);
  EXPECT_EQ(name(static_cast<Status>(words.size())), "unknown") << "a status without its word here";
  EXPECT_EQ(name(Status::doubtful), "doubtful");
  EXPECT_EQ(name(Status::too_few_data), "too_few_data");
}

TEST(Status, OkAndDoubtfulAloneAreUsable) {
  for (std::size_t i = 0; name(static_cast<Status>(i)) != "unknown"; ++i) {
    const auto status = static_cast<Status>(i);
    EXPECT_EQ(is_usable(status), status == Status::ok || status == Status::doubtful) << name(status);
  }
}

TEST(Status, ANumberThatIsNoneIsNotUsable) {
  EXPECT_EQ(name(static_cast<Status>(99)), "unknown");
  EXPECT_FALSE(is_usable(static_cast<Status>(99)));
}

}  // namespace
}  // namespace jointid
