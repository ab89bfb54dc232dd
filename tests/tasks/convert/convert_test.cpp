#include "tasks/convert/convert.hpp"

#include <gmock/gmock.h>

#include "problems/case/modal_set.hpp"
#include "tests/test_folder.hpp"

namespace jointid::tasks {
namespace {

class Convert : public testing::Test {
 protected:
  TestFolder folder_;
  frf::FrfSet set_ = problems::polluted(problems::make_modal_set("modes-pair"), 1, 0);
};

TEST_F(Convert, KeepsValuesAndVariances) {
  const auto source = frf::from_memory(set_);
  for (const char* name : {"pair.h5", "pair.csv"}) {
    ASSERT_TRUE(convert(*source, folder_ / name));
    const frf::FrfSet read = frf::load(*frf::open(folder_ / name));
    EXPECT_EQ(read.values.size(), set_.values.size()) << name;
    EXPECT_NEAR(std::abs(read.values[77] - set_.values[77]), 0.0, 1e-12 * std::abs(set_.values[77])) << name;
    EXPECT_EQ(read.variance.size(), set_.variance.size()) << name;
  }
}

TEST_F(Convert, LeavesNoFileWhenInterrupted) {
  ident::Control control;
  control.interrupted = [] { return true; };
  EXPECT_FALSE(convert(*frf::from_memory(set_), folder_ / "pair.h5", control));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "pair.h5"));
}

}  // namespace
}  // namespace jointid::tasks
