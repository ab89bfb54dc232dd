#include "report/result/study_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/text/words.hpp"
#include "base/statistics.hpp"
#include "frf/hdf5/table_file.hpp"
#include "study/study_histogram.hpp"
#include "study/study_row.hpp"

namespace jointid::report {
namespace {

constexpr std::size_t histograms_together = 12;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A histogram to be filled, and the column that fills it.
struct Draft {
  HistogramPlot plot;
  study::ColumnBins bins;
  std::size_t choice = 0;
};

/// Beyond the quantiles by 0.6 of what is between them, 3.6 standard deviations of a normal law, within `limits`; as far as the
/// mark when that is not further off than the bins are wide.
std::optional<std::array<double, 2>> range_of(const study::Quantiles& quantiles, const std::optional<double>& mark,
                                              const std::array<double, 2>& limits) {
  const double between = quantiles.back() - quantiles.front();
  const double size = std::max(std::abs(quantiles.front()), std::abs(quantiles.back()));
  if (!(between > 1e-9 * size)) return std::nullopt;
  double low = quantiles.front() - 0.6 * between, high = quantiles.back() + 0.6 * between;
  const double width = high - low;
  if (mark && *mark > low - width && *mark < high + width) {
    low = std::min(low, *mark - 0.05 * width);
    high = std::max(high, *mark + 0.05 * width);
  }
  return std::array{std::max(low, limits[0]), std::min(high, limits[1])};
}

/// The rule of Freedman and Diaconis (1981), between 8 and 60 bins.
std::size_t bins_for(std::size_t trials, const study::Quantiles& quantiles, double range) {
  const double width = 2.0 * (quantiles[3] - quantiles[1]) / std::cbrt(static_cast<double>(trials));
  return static_cast<std::size_t>(std::clamp(width > 0.0 ? range / width : 60.0, 8.0, 60.0));
}

/// Drafts of what varies.
class Drafts {
 public:
  explicit Drafts(std::size_t trials) : trials_(trials) {}

  void add(const std::string& title, const std::string& label, std::size_t column, const study::Quantiles& quantiles,
           const std::optional<double>& mark, const char* mark_name, std::array<double, 2> limits, std::size_t choice) {
    const auto range = range_of(quantiles, mark, limits);
    if (!range) return;
    const auto [low, high] = *range;
    drafts_.push_back({{title, {label, false}, low, high, {}, mark, mark_name},
                       {column, low, high, bins_for(trials_, quantiles, high - low)},
                       choice});
  }

  /// Filled from the file, as the choices of those names.
  PlotGroup filled(const std::filesystem::path& file, const char* menu, const std::vector<std::string>& choices) && {
    std::vector<study::ColumnBins> columns;
    for (const Draft& draft : drafts_) columns.push_back(draft.bins);
    const std::vector<study::Histogram> histograms = study::study_histograms(file, columns);
    PlotGroup group{menu, {}};
    for (const std::string& name : choices) group.choices.push_back({name, {}});
    for (std::size_t i = 0; i < drafts_.size(); ++i) {
      HistogramPlot& plot = drafts_[i].plot;
      plot.counts.assign(histograms[i].counts.begin(), histograms[i].counts.end());
      if (histograms[i].outside > 0) plot.title += fmt::format(" ({} outside)", histograms[i].outside);
      group.choices[drafts_[i].choice].plots.emplace_back(std::move(plot));
    }
    std::erase_if(group.choices, [](const Choice& choice) { return choice.plots.empty(); });
    return group;
  }

 private:
  std::size_t trials_;
  std::vector<Draft> drafts_;
};

}  // namespace

PlotGroup unknown_histograms(const std::filesystem::path& file, const study::StudyStatistics& statistics, std::size_t most) {
  const study::StudyColumns at = study::columns_of(frf::TableReader(file).header());
  const std::size_t shown = std::min(most, statistics.unknowns.size());
  Drafts drafts(statistics.usable);
  std::vector<std::string> choices;
  for (std::size_t i = 0; i < shown; ++i) {
    const study::UnknownStatistics& unknown = statistics.unknowns[i];
    if (i % histograms_together == 0) {
      const std::string& last = statistics.unknowns[std::min(i + histograms_together, shown) - 1].name;
      choices.push_back(last == unknown.name ? last : unknown.name + " … " + last);
    }
    drafts.add(unknown.name, unknown.unit, at.value(i), unknown.quantiles, unknown.truth, "truth", {-infinity, infinity},
               choices.size() - 1);
  }
  return std::move(drafts).filled(file, "unknowns", choices);
}

std::optional<HistogramPlot> histogram_of(const std::string& title, const std::string& label, std::vector<double> values,
                                          const std::optional<double>& truth) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return std::nullopt;
  std::ranges::sort(values);
  study::Quantiles quantiles{};
  for (std::size_t i = 0; i < quantiles.size(); ++i) quantiles[i] = quantile(values, study::study_quantiles[i]);
  const auto range = range_of(quantiles, truth, {-infinity, infinity});
  if (!range) return std::nullopt;
  const auto [low, high] = *range;
  HistogramPlot plot{title, {label, false}, low, high, {}, truth, "truth"};
  plot.counts.assign(bins_for(values.size(), quantiles, high - low), 0.0);
  const double width = (high - low) / static_cast<double>(plot.counts.size());
  std::size_t outside = 0;
  for (const double value : values) {
    if (value < low || value > high)
      ++outside;
    else
      plot.counts[std::min(plot.counts.size() - 1, static_cast<std::size_t>((value - low) / width))] += 1.0;
  }
  if (outside > 0) plot.title += fmt::format(" ({} outside)", outside);
  return plot;
}

PlotGroup quality_histograms(const std::filesystem::path& file, const study::StudyStatistics& statistics) {
  const study::StudyColumns at = study::columns_of(frf::TableReader(file).header());
  Drafts drafts(statistics.usable);
  std::vector<std::string> choices;
  for (std::size_t k = 0; k < statistics.quality.size(); ++k) {
    const study::QualityStatistics& matrix = statistics.quality[k];
    const std::size_t first = at.quality(k);
    choices.push_back(words(matrix.matrix));
    drafts.add("RJCF", "", first, matrix.rjcf, 1.0, "ideal", {0.0, 1.0}, k);
    drafts.add("ARVF", "", first + 1, matrix.arvf, 1.0, "ideal", {-infinity, infinity}, k);
    drafts.add("rms relative error", "", first + 2, matrix.rms_relative_error, std::nullopt, "", {0.0, infinity}, k);
  }
  return std::move(drafts).filled(file, "matrix", choices);
}

}  // namespace jointid::report
