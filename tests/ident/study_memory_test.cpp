#include <gtest/gtest.h>

#include <filesystem>

#include "counted_memory.hpp"
#include "frf/hdf5/table_file.hpp"
#include "study/study.hpp"
#include "study/study_statistics.hpp"
#include "problems/case/in_memory.hpp"
#include "problems/problem.hpp"
#include "tests/test_folder.hpp"

namespace jointid::ident {
namespace {

/// Two lines of case A1: a trial takes little time.
std::shared_ptr<const study::TrialData> small_data() {
  const problems::Problem problem = problems::make("A1");
  Scene scene = problems::scene(problem);
  scene.frequency.range_hz = Range{500.0, 520.0};
  return problems::trial_data(scene, problem);
}

std::size_t peak_of_study(const std::shared_ptr<const study::TrialData>& data, std::size_t trials) {
  study::StudyOptions options;
  options.trials = trials;
  options.threads = 1;
  const TestFolder folder;
  options.out = folder / "study.h5";
  const auto team = make_team_of_one();
  return peak_bytes_of([&] {
    EXPECT_TRUE(study::run_study(data, options, *team).complete);
    EXPECT_EQ(study::study_statistics(options.out).trials, trials);
  });
}

TEST(StudyMemory, DoesNotGrowWithTheTrials) {
  const auto data = small_data();
  peak_of_study(data, 100);  // what is allocated once
  const std::size_t few = peak_of_study(data, 10'000), many = peak_of_study(data, 40'000);
  EXPECT_LT(few, 10'000'000u);
  EXPECT_LT(many, few + 1'000);  // a bit per trial would be 3,750 bytes
}

/// A study of one unknown that no trial computed.
std::size_t peak_of_statistics(std::size_t trials) {
  const TestFolder folder;
  const Path path = folder / "study.h5";
  frf::TableHeader header{.texts = {{"unknowns", "1"}, {"judged", ""}, {"intervals", "no"}},
                          .columns = {{"status", "", 0.0}, {"K(1,1)", "N/m", 0.5}}};
  frf::TableWriter table(path, header, trials);
  for (std::size_t i = 0; i < trials; ++i) {
    const auto spread = static_cast<double>((i * 2654435761U) % 4294967291U) / 4294967291.0;
    table.append(std::vector<double>{0.0, spread});
  }
  table.finish();
  return peak_bytes_of([&] { EXPECT_NEAR(study::study_statistics(path).unknowns.front().quantiles[2], 0.5, 0.01); });
}

TEST(StudyMemory, OfStatisticsIsBounded) {
  peak_of_statistics(100);
  EXPECT_LT(peak_of_statistics(100'000), 1'500'000u);
  EXPECT_LT(peak_of_statistics(1'000'000), 1'500'000u);  // the column has 8 MB
}

}  // namespace
}  // namespace jointid::ident
