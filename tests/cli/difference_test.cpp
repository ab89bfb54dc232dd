// How `jointid rerun` compares two results.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/rerun/difference.hpp"

namespace jointid::cli {
namespace {

TEST(Difference, NumbersOfAMatrixAreComparedByItsLargest) {
  const report::Json before = {{"K", {{4e6, 1e-9}, {1e-9, 2e6}}}, {"k", 1e-9}, {"rows", {{{"k", 1e-9}}, {{"k", 1.0}}}}};
  report::Json after = before;
  after["K"][0][1] = -1e-9;
  EXPECT_NEAR(difference_of(before, after).largest, 5e-16, 1e-20);
  after["K"][1][1] = 2.2e6;
  EXPECT_NEAR(difference_of(before, after).largest, 0.05, 1e-12);
  after = before;
  after["rows"][0]["k"] = 2e-9;  // rows of a table have other units: by itself
  EXPECT_NEAR(difference_of(before, after).largest, 0.5, 1e-12);
}

}  // namespace
}  // namespace jointid::cli
