#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/study_statistics.hpp"

namespace jointid::tasks {

/// How often the values of trials fall into bins of equal width from `low` to `high`.
struct TrialHistogram {
  std::size_t of = 0;      ///< number of the unknown, or of the judged matrix
  std::string name, unit;  ///< of the unknown, SI; "RJCF", "ARVF" or "rms relative error" of a matrix
  double low = 0.0, high = 1.0;
  std::vector<std::size_t> counts;  ///< a bin each
  std::size_t outside = 0;          ///< values below low or above high
  std::optional<double> mark;       ///< truth of an unknown; 1 of RJCF and ARVF
};

/// Of the first `most` unknowns of a study's result file. Bins reach a little beyond the 5 and 95 % quantiles, and to a truth
/// that is near. What does not vary is left out. Memory does not depend on the number of trials. Throws InputError for files of
/// no study.
std::vector<TrialHistogram> unknown_histograms(const std::filesystem::path& file, const study::StudyStatistics& statistics,
                                               std::size_t most);

/// Of RJCF, ARVF and rms relative error of every judged matrix.
std::vector<TrialHistogram> quality_histograms(const std::filesystem::path& file, const study::StudyStatistics& statistics);

/// Those that a page shows.
struct StudyHistograms {
  std::vector<TrialHistogram> unknowns, quality;
};
StudyHistograms study_histograms(const std::filesystem::path& file, const study::StudyStatistics& statistics,
                                 std::size_t most_unknowns);

/// Of values in memory, with the same bins; empty where they do not vary.
std::optional<TrialHistogram> histogram_of(const std::string& name, const std::string& unit, std::vector<double> values,
                                           const std::optional<double>& truth);

}  // namespace jointid::tasks
