#include "report/result/study_plots.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/text/words.hpp"

namespace jointid::report {
namespace {

constexpr std::size_t histograms_together = 12;

/// Choices without a plot are left out.
PlotGroup without_empty(PlotGroup group) {
  std::erase_if(group.choices, [](const Choice& choice) { return choice.plots.empty(); });
  return group;
}

const char* mark_of(const tasks::TrialHistogram& histogram) { return histogram.mark ? "ideal" : ""; }

}  // namespace

HistogramPlot histogram_plot(const tasks::TrialHistogram& histogram, const char* mark_name) {
  HistogramPlot plot{histogram.name, {histogram.unit, false}, histogram.low, histogram.high, {}, histogram.mark, mark_name};
  plot.counts.assign(histogram.counts.begin(), histogram.counts.end());
  if (histogram.outside > 0) plot.title += fmt::format(" ({} outside)", histogram.outside);
  return plot;
}

PlotGroup study_unknown_plots(const std::vector<tasks::TrialHistogram>& histograms, const study::StudyStatistics& statistics,
                              std::size_t most) {
  const std::size_t shown = std::min(most, statistics.unknowns.size());
  PlotGroup group{"unknowns", {}};
  for (std::size_t i = 0; i < shown; i += histograms_together) {
    const std::string &first = statistics.unknowns[i].name,
                      &last = statistics.unknowns[std::min(i + histograms_together, shown) - 1].name;
    group.choices.push_back({last == first ? last : first + " … " + last, {}});
  }
  for (const tasks::TrialHistogram& histogram : histograms)
    group.choices[histogram.of / histograms_together].plots.emplace_back(histogram_plot(histogram));
  return without_empty(std::move(group));
}

PlotGroup study_quality_plots(const std::vector<tasks::TrialHistogram>& histograms, const study::StudyStatistics& statistics) {
  PlotGroup group{"matrix", {}};
  for (const study::QualityStatistics& matrix : statistics.quality) group.choices.push_back({words(matrix.matrix), {}});
  for (const tasks::TrialHistogram& histogram : histograms)
    group.choices[histogram.of].plots.emplace_back(histogram_plot(histogram, mark_of(histogram)));
  return without_empty(std::move(group));
}

}  // namespace jointid::report
