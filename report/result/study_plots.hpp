#pragma once

#include "report/page/contents.hpp"
#include "study/study_statistics.hpp"

/// The plots of a study report.
namespace jointid::report {

/// Histograms of the first `most` unknowns with the truth marked, twelve together. Bins reach a little beyond the 5 and 95 %
/// quantiles; the title tells how many trials are outside. What does not vary is left out. Memory does not depend on the
/// number of trials. `file`: that of the study.
PlotGroup unknown_histograms(const std::filesystem::path& file, const study::StudyStatistics& statistics, std::size_t most);

/// Of values in memory, with the same bins; empty where they do not vary.
std::optional<HistogramPlot> histogram_of(const std::string& title, const std::string& label, std::vector<double> values,
                                          const std::optional<double>& truth);

/// Histograms of RJCF, ARVF and rms relative error, one choice per matrix.
PlotGroup quality_histograms(const std::filesystem::path& file, const study::StudyStatistics& statistics);

}  // namespace jointid::report
