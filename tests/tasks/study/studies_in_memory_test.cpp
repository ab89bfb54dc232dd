// Studies, comparisons and checks of FRFs in memory are those of the files.
#include <gmock/gmock.h>

#include "base/control.hpp"
#include "ident/scene/read_scene.hpp"
#include "ident/whole_check.hpp"
#include "problems/problem.hpp"
#include "study/trial_data.hpp"
#include "tasks/compare/compare_ways.hpp"
#include "tasks/study/run_study.hpp"
#include "tests/test_folder.hpp"

namespace jointid::tasks {
namespace {

class StudiesInMemory : public testing::Test {
 protected:
  StudiesInMemory()
      : scene_(ident::read_scene(problems::write(problem_, folder_, {.format = "h5", .seed = 1, .clean = true}))),
        sets_{problem_.substructures, {problem_.assembly}} {}

  study::StudyOptions options(const char* name) const {
    study::StudyOptions out;
    out.trials = 4;
    out.threads = 1;
    out.out = folder_ / name;
    return out;
  }

  TestFolder folder_;
  problems::Problem problem_ = problems::make("A1");
  ident::Scene scene_;
  study::Measurements sets_;
};

TEST_F(StudiesInMemory, GiveTheTrialsOfTheFiles) {
  const StudyResult of_files = run_study(study::load_trial_data(scene_), options("files.h5"));
  const StudyResult in_memory = run_study(study::make_trial_data(scene_, sets_), options("memory.h5"));
  EXPECT_TRUE(in_memory.run.complete);
  EXPECT_EQ(in_memory.statistics.trials, 4U);
  ASSERT_EQ(in_memory.statistics.unknowns.size(), of_files.statistics.unknowns.size());
  for (std::size_t i = 0; i < in_memory.statistics.unknowns.size(); ++i)
    EXPECT_EQ(in_memory.statistics.unknowns[i].mean, of_files.statistics.unknowns[i].mean);
}

TEST_F(StudiesInMemory, StopWhenAsked) {
  study::StudyControl control;
  control.interrupted = [] { return true; };
  study::StudyOptions asked = options("stopped.h5");
  asked.trials = 200'000;
  const StudyResult stopped = run_study(study::make_trial_data(scene_, sets_), asked, control);
  EXPECT_FALSE(stopped.run.complete);
  EXPECT_LT(stopped.run.done, asked.trials);
  EXPECT_EQ(stopped.statistics.trials, 0U);
  EXPECT_FALSE(std::filesystem::exists(asked.out));
  EXPECT_TRUE(std::filesystem::exists(study::journal_path(asked.out)));
}

TEST_F(StudiesInMemory, CompareTheWaysOfTheFiles) {
  study::Alternatives ways;
  ways.deltas = {0.0, 0.05};
  std::size_t told = 0;
  const study::TrialOptions trials{.trials = 2, .threads = 1};
  const ComparisonResult of_files = compare_ways(scene_, ways, trials);
  const ComparisonResult in_memory = compare_ways(
      scene_, sets_, ways, trials, [&](const ComparisonResult& so_far) { told = so_far.comparison.combinations.size(); });
  EXPECT_EQ(told, 2U);
  EXPECT_EQ(in_memory.trials, 2U);
  EXPECT_TRUE(some_usable(in_memory));
  ASSERT_EQ(in_memory.comparison.combinations.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(in_memory.comparison.combinations[i].matrices.front().rjcf.median,
              of_files.comparison.combinations[i].matrices.front().rjcf.median);
  }
  EXPECT_FALSE(some_usable(ComparisonResult()));
}

TEST_F(StudiesInMemory, ChecksFindWhatThoseOfTheFilesFind) {
  EXPECT_EQ(ident::check_whole(scene_, sets_.substructures, sets_.assembly).verdict, ident::check_whole(scene_).verdict);
  frf::FrfSet& assembly = sets_.assembly.front();
  for (std::size_t line = 0; line < assembly.header.lines(); ++line) {
    for (std::size_t c = 0; c < assembly.header.reference.size(); ++c) assembly.values[assembly.index(line, 2, c)] *= -1.0;
  }
  const ident::CheckResult found = ident::check_whole(scene_, sets_.substructures, sets_.assembly);
  ASSERT_FALSE(found.suspects.empty());
  EXPECT_EQ(found.suspects.front().kind, ident::SuspectKind::sign);
}

}  // namespace
}  // namespace jointid::tasks
