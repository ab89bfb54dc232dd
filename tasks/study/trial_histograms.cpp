#include "tasks/study/trial_histograms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/statistics.hpp"
#include "frf/hdf5/table_file.hpp"
#include "study/study_histogram.hpp"
#include "study/study_row.hpp"

namespace jointid::tasks {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

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

/// Histograms of what varies, to be filled from a file.
class Drafts {
 public:
  explicit Drafts(std::size_t trials) : trials_(trials) {}

  void add(TrialHistogram histogram, std::size_t column, const study::Quantiles& quantiles, std::array<double, 2> limits) {
    const auto range = range_of(quantiles, histogram.mark, limits);
    if (!range) return;
    histogram.low = (*range)[0];
    histogram.high = (*range)[1];
    columns_.push_back({column, histogram.low, histogram.high, bins_for(trials_, quantiles, histogram.high - histogram.low)});
    histograms_.push_back(std::move(histogram));
  }

  std::vector<TrialHistogram> filled(const std::filesystem::path& file) && {
    const std::vector<study::Histogram> counted = study::study_histograms(file, columns_);
    for (std::size_t i = 0; i < histograms_.size(); ++i) {
      histograms_[i].counts = counted[i].counts;
      histograms_[i].outside = counted[i].outside;
    }
    return std::move(histograms_);
  }

 private:
  std::size_t trials_;
  std::vector<TrialHistogram> histograms_;
  std::vector<study::ColumnBins> columns_;
};

}  // namespace

std::vector<TrialHistogram> unknown_histograms(const std::filesystem::path& file, const study::StudyStatistics& statistics,
                                               std::size_t most) {
  const study::StudyColumns at = study::columns_of(frf::TableReader(file).header());
  Drafts drafts(statistics.usable);
  for (std::size_t i = 0; i < std::min(most, statistics.unknowns.size()); ++i) {
    const study::UnknownStatistics& unknown = statistics.unknowns[i];
    drafts.add({.of = i, .name = unknown.name, .unit = unknown.unit, .counts = {}, .mark = unknown.truth}, at.value(i),
               unknown.quantiles, {-infinity, infinity});
  }
  return std::move(drafts).filled(file);
}

std::vector<TrialHistogram> quality_histograms(const std::filesystem::path& file, const study::StudyStatistics& statistics) {
  const study::StudyColumns at = study::columns_of(frf::TableReader(file).header());
  Drafts drafts(statistics.usable);
  for (std::size_t k = 0; k < statistics.quality.size(); ++k) {
    const study::QualityStatistics& matrix = statistics.quality[k];
    const std::size_t first = at.quality(k);
    drafts.add({.of = k, .name = "RJCF", .unit = "", .counts = {}, .mark = 1.0}, first, matrix.rjcf, {0.0, 1.0});
    drafts.add({.of = k, .name = "ARVF", .unit = "", .counts = {}, .mark = 1.0}, first + 1, matrix.arvf, {-infinity, infinity});
    drafts.add({.of = k, .name = "rms relative error", .unit = "", .counts = {}, .mark = {}}, first + 2,
               matrix.rms_relative_error, {0.0, infinity});
  }
  return std::move(drafts).filled(file);
}

StudyHistograms study_histograms(const std::filesystem::path& file, const study::StudyStatistics& statistics,
                                 std::size_t most_unknowns) {
  return {unknown_histograms(file, statistics, most_unknowns), quality_histograms(file, statistics)};
}

std::optional<TrialHistogram> histogram_of(const std::string& name, const std::string& unit, std::vector<double> values,
                                           const std::optional<double>& truth) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  if (values.empty()) return std::nullopt;
  std::ranges::sort(values);
  study::Quantiles quantiles{};
  for (std::size_t i = 0; i < quantiles.size(); ++i) quantiles[i] = quantile(values, study::study_quantiles[i]);
  const auto range = range_of(quantiles, truth, {-infinity, infinity});
  if (!range) return std::nullopt;
  const auto [low, high] = *range;
  TrialHistogram out{.of = 0, .name = name, .unit = unit, .low = low, .high = high, .counts = {}, .outside = 0, .mark = truth};
  out.counts.assign(bins_for(values.size(), quantiles, high - low), 0);
  const double width = (high - low) / static_cast<double>(out.counts.size());
  for (const double value : values) {
    if (value < low || value > high)
      ++out.outside;
    else
      ++out.counts[std::min(out.counts.size() - 1, static_cast<std::size_t>((value - low) / width))];
  }
  return out;
}

}  // namespace jointid::tasks
