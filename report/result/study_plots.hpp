#pragma once

#include "report/page/contents.hpp"
#include "tasks/study/trial_histograms.hpp"

/// The plots of a study report.
namespace jointid::report {

/// A histogram; its title tells how many trials are outside. `mark_name`: what its mark is.
HistogramPlot histogram_plot(const tasks::TrialHistogram& histogram, const char* mark_name = "truth");

/// Histograms of unknowns with the truth marked, twelve together, named by the first and the last of the first `most`.
PlotGroup study_unknown_plots(const std::vector<tasks::TrialHistogram>& histograms, const study::StudyStatistics& statistics,
                              std::size_t most);

/// Histograms of RJCF, ARVF and rms relative error, one choice per matrix.
PlotGroup study_quality_plots(const std::vector<tasks::TrialHistogram>& histograms, const study::StudyStatistics& statistics);

}  // namespace jointid::report
