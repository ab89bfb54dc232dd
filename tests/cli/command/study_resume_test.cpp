// A study that goes on from a finished one, and what is said where it cannot.
#include <gmock/gmock.h>

#include "input_folder.hpp"
#include "run_command.hpp"

namespace jointid::cli {
namespace {

using ::testing::HasSubstr;

Outcome study(const InputFolder& folder, std::vector<std::string> options) {
  std::vector<std::string> arguments = {"study", "A1.toml", "--threads", "1"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_command(folder.path(), arguments);
}

TEST(StudyResume, GoesOnWithMoreTrials) {
  const InputFolder folder;
  ASSERT_EQ(study(folder, {"--trials", "5", "--out", "a.h5"}).code, 0);
  ASSERT_EQ(study(folder, {"--trials", "12", "--out", "a.h5", "--resume"}).code, 0);
  ASSERT_EQ(study(folder, {"--trials", "12", "--out", "b.h5"}).code, 0);
  EXPECT_TRUE(folder.text("a.h5") == folder.text("b.h5")) << "equal studies are equal files";
  EXPECT_FALSE(std::filesystem::exists(folder.path("a.h5.partial")));
  EXPECT_THAT(study(folder, {"--trials", "12", "--out", "a.h5", "--resume"}).out, HasSubstr("12"));
}

TEST(StudyResume, SaysWhatDiffers) {
  const InputFolder folder;
  ASSERT_EQ(study(folder, {"--trials", "5", "--out", "a.h5"}).code, 0);
  const auto refused = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--out", "a.h5", "--resume"});
    const Outcome outcome = study(folder, options);
    EXPECT_EQ(outcome.code, 2) << outcome.err;
    return outcome.err;
  };
  EXPECT_THAT(refused({"--trials", "3"}),
              HasSubstr("a.h5: --resume: it has 5 trials already; repeat that run with as many trials or more"));
  EXPECT_THAT(refused({"--trials", "6", "--seed", "2"}), HasSubstr("it is complete and belongs to another seed;"));
  folder.replace("A1.toml", "[identify]", "[identify]\ndelta = 0.07");
  EXPECT_THAT(refused({"--trials", "6"}), HasSubstr("it is complete and belongs to another scene;"));
  EXPECT_THAT(refused({"--trials", "6", "--seed", "2"}), HasSubstr("belongs to another scene and another seed;"));
}

/// Only what a scene asks for makes it another.
TEST(StudyResume, ATitleACommentOrSpacingIsNotAnotherScene) {
  const InputFolder folder;
  ASSERT_EQ(study(folder, {"--trials", "5", "--out", "a.h5"}).code, 0);
  folder.write("A1.toml", "# made on Monday\n" + folder.text("A1.toml") + "\n\n# end\n");
  folder.replace("A1.toml", "title = \"", "title   = \"another ");
  const Outcome outcome = study(folder, {"--trials", "7", "--out", "a.h5", "--resume"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("2 trials in"));
}

/// One number of a finished study changed, or zeros in it: no statistics.
TEST(StudyResume, ADamagedResultIsRefused) {
  const InputFolder folder;
  ASSERT_EQ(study(folder, {"--trials", "40", "--out", "a.h5"}).code, 0);
  const std::string good = folder.text("a.h5");
  std::size_t refused = 0, same = 0;
  const std::string said = study(folder, {"--trials", "40", "--out", "a.h5", "--resume", "--csv", "-"}).out;
  for (std::size_t i = 0; i < 10; ++i) {
    std::string bad = good;
    const std::size_t at = good.size() / 2 + i * good.size() / 25;
    for (std::size_t k = 0; k < 24; ++k) bad[at + k] = static_cast<char>(i % 2 == 0 ? 0 : bad[at + k] ^ 0x10);
    folder.write("a.h5", bad);
    const Outcome outcome = study(folder, {"--trials", "40", "--out", "a.h5", "--resume", "--csv", "-"});
    refused += outcome.code == 3 ? 1 : 0;
    same += outcome.code == 0 && outcome.out == said ? 1U : 0U;
    EXPECT_EQ(refused + same, i + 1) << "other statistics, or another exit code: " << outcome.code << outcome.err;
  }
  EXPECT_GT(refused, 5U);
}

}  // namespace
}  // namespace jointid::cli
