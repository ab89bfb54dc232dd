#include "study/study_histogram.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <numeric>

#include "base/statistics.hpp"
#include "frf/hdf5/table_file.hpp"
#include "ident/result/solution.hpp"
#include "tests/test_folder.hpp"

namespace jointid::study {
namespace {

using testing::ElementsAre;

constexpr double ok = static_cast<double>(ident::Status::ok), failed = static_cast<double>(ident::Status::rank_deficient);

ident::Path written(const TestFolder& folder, std::size_t rows, const std::vector<double>& numbers) {
  const ident::Path path = folder / "study.h5";
  frf::TableWriter table(path, {.texts = {}, .columns = {{"status", "", nan}, {"K", "N/m", nan}, {"D", "N/m", nan}}}, rows);
  table.append(numbers);
  table.finish();
  return path;
}

TEST(StudyHistogram, CountsUsableTrialsBinByBin) {
  const TestFolder folder;
  const ident::Path file = written(folder, 6, {ok, 0.0, 5.0, ok, 0.5, 6.0, failed, 0.6, 5.0, ok, 1.0, nan, ok, 1.1, 5.5, ok, -0.1, 5.5});
  const auto histograms = study_histograms(file, {{1, 0.0, 1.0, 2}, {2, 5.0, 6.0, 4}});
  ASSERT_EQ(histograms.size(), 2u);
  EXPECT_THAT(histograms[0].counts, ElementsAre(1, 2));
  EXPECT_EQ(histograms[0].outside, 2u);
  EXPECT_THAT(histograms[1].counts, ElementsAre(1, 0, 2, 1));
  EXPECT_EQ(histograms[1].outside, 0u);
}

/// More rows than are read at once.
TEST(StudyHistogram, EveryTrialOfALargeFileCounts) {
  const std::size_t rows = 200001;
  std::vector<double> numbers;
  for (std::size_t i = 0; i < rows; ++i) {
    numbers.insert(numbers.end(), {ok, static_cast<double>(i % 10) + 0.5, 0.0});
  }
  const TestFolder folder;
  const Histogram histogram = study_histograms(written(folder, rows, numbers), {{1, 0.0, 10.0, 10}}).front();
  EXPECT_EQ(histogram.counts[0], 20001u);
  EXPECT_EQ(histogram.counts[9], 20000u);
  EXPECT_EQ(std::accumulate(histogram.counts.begin(), histogram.counts.end(), histogram.outside), rows);
}

}  // namespace
}  // namespace jointid::study
