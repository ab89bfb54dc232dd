// Studies in parts, as arrays of jobs make them: killed, resumed, merged.
#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "base/error.hpp"
#include "input_folder.hpp"
#include "run_command.hpp"
#include "study/study_records.hpp"

namespace jointid::cli {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;

constexpr int parts_of_study = 16;
const std::string trials_of_study = "1600";

std::string part_file(int part) { return "part" + std::to_string(part) + ".h5"; }

std::vector<std::string> part_command(int part, int parts = parts_of_study) {
  const std::string share = std::to_string(part) + "/" + std::to_string(parts);
  return {"study", "A1.toml", "--trials", trials_of_study, "--threads", "1", "--part", share, "--out", part_file(part), "--resume"};
}

std::vector<std::string> merge_command(int parts) {
  std::vector<std::string> out = {"study", "--out", "merged.h5", "--merge"};
  for (int part = parts; part > 0; --part) out.push_back(part_file(part));  // in any order
  return out;
}

/// The study in one run.
std::string whole_study(const InputFolder& folder) {
  const Outcome whole = run_command(folder.path(), {"study", "A1.toml", "--trials", trials_of_study, "--out", "whole.h5"});
  EXPECT_EQ(whole.code, 0) << whole.err;
  return folder.text("whole.h5");
}

TEST(StudyParts, SixteenKilledAtRandomMomentsResumedAndMergedAreTheStudyInOneRun) {
  const InputFolder folder;
  const std::string whole = whole_study(folder);
  std::mt19937 random(16);
  std::uniform_int_distribution<int> milliseconds(5, 120);
  int kills = 0;
  for (int part = 1; part <= parts_of_study; ++part) {
    for (int times = 0; times < 3; ++times) {
      Command command(folder.path(), part_command(part));
      std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds(random)));
      kills += command.has_ended() ? 0 : 1;
      command.interrupt(SIGKILL);
      command.wait();
    }
    const Outcome finished = run_command(folder.path(), part_command(part));
    ASSERT_EQ(finished.code, 0) << part << finished.err;
  }
  EXPECT_GT(kills, parts_of_study) << "nothing was killed";
  const Outcome merged = run_command(folder.path(), merge_command(parts_of_study));
  ASSERT_EQ(merged.code, 0) << merged.err;
  EXPECT_TRUE(folder.text("merged.h5") == whole) << "other bytes";
}

class ThreeParts : public ::testing::Test {
 protected:
  void SetUp() override {
    for (int part = 1; part <= 3; ++part) ASSERT_EQ(run_command(folder_.path(), part_command(part, 3)).code, 0) << part;
  }

  std::string refusal(const std::vector<std::string>& files) {
    std::vector<std::string> words = {"study", "--out", "merged.h5", "--merge"};
    words.insert(words.end(), files.begin(), files.end());
    const Outcome merged = run_command(folder_.path(), words);
    EXPECT_THAT(merged.code, AnyOf(2, 3)) << merged.err;
    EXPECT_FALSE(std::filesystem::exists(folder_.path("merged.h5")));
    return merged.err;
  }

  InputFolder folder_;
};

TEST_F(ThreeParts, AreRefusedWhereOneIsMissingTwiceThereOrOfAnotherStudy) {
  EXPECT_THAT(refusal({"part1.h5", "part3.h5"}), HasSubstr("2/3"));
  std::filesystem::copy_file(folder_.path("part1.h5"), folder_.path("again.h5"));
  EXPECT_THAT(refusal({"part1.h5", "again.h5", "part2.h5", "part3.h5"}), HasSubstr("1/3"));
  std::vector<std::string> other = part_command(2, 3);
  other.insert(other.end(), {"--seed", "9"});
  *(std::ranges::find(other, "--out") + 1) = "other.h5";
  ASSERT_EQ(run_command(folder_.path(), other).code, 0);
  EXPECT_THAT(refusal({"part1.h5", "other.h5", "part3.h5"}), HasSubstr("other.h5"));
  whole_study(folder_);
  EXPECT_THAT(refusal({"whole.h5", "part2.h5", "part3.h5"}), HasSubstr("whole.h5"));
}

TEST_F(ThreeParts, CutAnywhereAreAnErrorOrTheRightStudy) {
  const std::string whole = whole_study(folder_), bytes = folder_.text("part2.h5");
  const std::vector<std::filesystem::path> files = {folder_.path("part1.h5"), folder_.path("part2.h5"), folder_.path("part3.h5")};
  std::mt19937_64 random(1000);
  int refused = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::size_t length = std::uniform_int_distribution<std::size_t>(0, bytes.size() - 1)(random);
    std::ofstream(files[1], std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(length));
    try {
      study::merge_parts(files, folder_.path("merged.h5"));
      EXPECT_TRUE(folder_.text("merged.h5") == whole) << "cut to " << length;
    } catch (const InputError& error) {
      ++refused;
      EXPECT_THAT(error.what(), HasSubstr("part2.h5")) << "cut to " << length;
    }
  }
  EXPECT_GT(refused, 900);
}

}  // namespace
}  // namespace jointid::cli
