#include "study/study_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "base/statistics.hpp"
#include "frf/hdf5/table_file.hpp"
#include "study/study.hpp"
#include "study/trial_runner.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "tests/test_folder.hpp"

namespace jointid::study {
namespace {

TEST(StudyStatistics, AreThoseOfTheUsableTrials) {
  const TestFolder folder;
  const ident::Path path = folder / "statistics.h5";
  frf::TableHeader header{.texts = {{"unknowns", "1"}, {"judged", ""}, {"intervals", "yes"}},
                          .columns = {{"status", "", nan}, {"K(1,1)", "N/m", 10.0}, {"low", "", nan}, {"high", "", nan}}};
  frf::TableWriter table(path, header, 5);
  table.append(std::vector<double>{0, 8, 7, 9,  0, 11, 9, 13,  1, 99, nan, nan,  0, 12, 9, 15,  0, 13, 9, 17});
  table.finish();
  const StudyStatistics s = study_statistics(path);
  EXPECT_EQ(s.trials, 5u);
  EXPECT_EQ(s.usable, 4u);
  EXPECT_EQ(s.rank_deficient, 1u);
  const UnknownStatistics& k = s.unknowns.front();
  EXPECT_DOUBLE_EQ(k.mean, 11.0);
  EXPECT_DOUBLE_EQ(*k.bias, 1.0);
  EXPECT_DOUBLE_EQ(k.std_deviation, std::sqrt((9.0 + 0.0 + 1.0 + 4.0) / 3.0));
  EXPECT_DOUBLE_EQ(*k.rms_error, std::sqrt((4.0 + 1.0 + 4.0 + 9.0) / 4.0));
  EXPECT_DOUBLE_EQ(k.quantiles[2], 11.5);
  EXPECT_DOUBLE_EQ(k.quantiles[0], 8.0 + 0.15 * 3.0);
  EXPECT_DOUBLE_EQ(*k.coverage, 0.75);
}

TEST(StudyStatistics, OfAStudyAreThoseOfItsTrials) {
  const problems::Problem problem = problems::make("A10");
  const auto data = problems::trial_data(problems::scene(problem), problem);
  const TestFolder folder;
  const StudyOptions options{.trials = 40, .seed = 3, .threads = 2, .resume = false, .out = folder / "study.h5", .texts = {}};
  const auto team = ident::make_team_of_one();
  const StudyRun run = run_study(data, options, *team);
  EXPECT_TRUE(run.complete);
  EXPECT_EQ(run.computed, 40u);
  const StudyStatistics s = study_statistics(options.out);
  TrialRunner runner(data);
  for (std::size_t i = 0; i < data->unknowns.size(); ++i) {
    double sum = 0.0;
    for (std::uint64_t trial = 0; trial < 40; ++trial) sum += runner.run(3, trial).values[i];
    EXPECT_DOUBLE_EQ(s.unknowns[i].mean, sum / 40.0);
    EXPECT_EQ(s.unknowns[i].truth, data->unknowns[i].truth);
  }
}

}  // namespace
}  // namespace jointid::study
