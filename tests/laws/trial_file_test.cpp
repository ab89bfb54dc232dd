#include "laws/task/trial_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/control.hpp"
#include "base/error.hpp"
#include "laws/scene/read_law_scene.hpp"
#include "problems/vibration/law_problem_cases.hpp"
#include "tests/test_folder.hpp"

namespace jointid::laws {
namespace {

using testing::HasSubstr;

constexpr const char* text = R"([data]
parts = ["sdof-iwan_part_1.h5"]
[[data.levels]]
amplitude = 20.0
force_dofs = ["1:+Y"]
[[joint.friction]]
name = "slot"
dofs = ["1:+Y"]
law = "bilinear"
assumed = { a = 1e-5, k = 4e5 }
[frequency]
range = [80.0, 135.0]
[errors]
relative = 0.01
[identify]
harmonics = [1, 3]
)";

class Trials : public testing::Test {
 protected:
  Trials() {
    problems::write(problems::make_law_problem("sdof-iwan"), folder_, {});
    scene_ = parse_law_scene(text, folder_ / "plan.toml");
    key_ = {text, 4, law_study_plan(scene_, assumed_states(scene_))};
  }

  LawStudy run(TrialFile& file, std::size_t stop_after = 100) {
    std::size_t done = file.known().size();
    return study_laws(scene_, {.trials = 6,
                               .seed = 4,
                               .interrupted = [&] { return done >= stop_after; },
                               .progress = [&](std::size_t so_far, std::size_t) { done = so_far; },
                               .known = file.known(),
                               .made = [&](const LawTrial& trial) { file.add(trial); }});
  }

  std::string error_of(const TrialFileKey& key) const {
    try {
      TrialFile(folder_ / "trials.csv", key, true);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }

  TestFolder folder_;
  LawScene scene_;
  TrialFileKey key_;
};

/// Stopped after two trials, cut off inside a line, and continued: the statistics of one run, to their bits.
TEST_F(Trials, AreContinued) {
  TrialFile whole(folder_ / "whole.csv", key_, false);
  const LawStudy expected = run(whole);
  {
    TrialFile first(folder_ / "trials.csv", key_, false);
    EXPECT_THROW(run(first, 2), Interrupted);
  }
  std::ofstream(folder_ / "trials.csv", std::ios::app) << "5,ok,bil";
  TrialFile rest(folder_ / "trials.csv", key_, true);
  EXPECT_EQ(rest.known().size(), 2u);
  const LawStudy found = run(rest);
  ASSERT_EQ(found.values.size(), expected.values.size());
  EXPECT_EQ(found.usable, expected.usable);
  EXPECT_EQ(found.chi_square, expected.chi_square);
  for (std::size_t i = 0; i < found.values.size(); ++i) {
    EXPECT_EQ(found.values[i].rms_error, expected.values[i].rms_error);
    EXPECT_EQ(found.values[i].bias, expected.values[i].bias);
    EXPECT_EQ(found.values[i].covered, expected.values[i].covered);
  }
  const TrialFile all(folder_ / "trials.csv", key_, true);
  EXPECT_EQ(all.known().size(), 6u);
}

TEST_F(Trials, OfAnotherStudyAreRefused) {
  { TrialFile first(folder_ / "trials.csv", key_, false); }
  EXPECT_EQ(error_of(key_), "none");
  TrialFileKey other = key_;
  other.seed = 5;
  EXPECT_THAT(error_of(other), HasSubstr("its trials are of another seed;"));
  other = key_;
  other.scene += "# changed\n";
  EXPECT_THAT(error_of(other), HasSubstr("its trials are of another scene;"));
  other = key_;
  other.plan.values[0].bound *= 1.001;
  EXPECT_THAT(error_of(other), HasSubstr("its trials are of another set of data;"));
  EXPECT_THROW(TrialFile(folder_ / "absent" / "trials.csv", key_, false), InputError);
}

}  // namespace
}  // namespace jointid::laws
