#include "report/result/study_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/text/words.hpp"

namespace jointid::report {
namespace {

std::string optional_number(const std::optional<double>& value) { return value ? number(*value) : "–"; }

/// In percent of `scale`, which is not 0.
std::string in_percent(double value, double scale) {
  const double share = 100.0 * value / std::abs(scale);
  return std::isfinite(share) ? fmt::format("{:.3g}", share) : "–";
}

std::string in_percent(const std::optional<double>& value, double scale) { return value ? in_percent(*value, scale) : "–"; }

}  // namespace

std::string trials_text(const study::StudyStatistics& statistics) {
  std::string text = fmt::format("{}, {} with an estimate", statistics.trials, statistics.usable);
  if (statistics.rank_deficient > 0) text += fmt::format(", {} rank deficient", statistics.rank_deficient);
  if (statistics.no_equations > 0) text += fmt::format(", {} without equations", statistics.no_equations);
  if (statistics.not_converged > 0) text += fmt::format(", {} not converged", statistics.not_converged);
  if (statistics.poor_fit > 0) text += fmt::format(", {} of poor fit", statistics.poor_fit);
  if (statistics.doubtful > 0) text += fmt::format("; {} of them doubtful", statistics.doubtful);
  return text;
}

Table unknowns_table(const study::StudyStatistics& statistics) {
  const bool intervals = std::ranges::any_of(statistics.unknowns, [](const auto& unknown) { return unknown.coverage.has_value(); });
  std::vector<Column> columns = {{"name", Align::left}, {"true value"}, {"mean"}, {"unit", Align::left}, {"bias %"}, {"std %"},
                                 {"rms error %"}, {"5 %"}, {"25 %"}, {"median %"}, {"75 %"}, {"95 %"}};
  if (intervals) columns.push_back({"coverage"});
  Table table(std::move(columns));
  for (const study::UnknownStatistics& unknown : statistics.unknowns) {
    const double centre = unknown.truth.value_or(unknown.mean);
    std::vector<std::string> cells = {unknown.name, optional_number(unknown.truth), number(unknown.mean), unknown.unit,
                                      in_percent(unknown.bias, centre), in_percent(unknown.std_deviation, centre),
                                      in_percent(unknown.rms_error, centre)};
    for (const double quantile : unknown.quantiles) cells.push_back(in_percent(quantile - centre, centre));
    if (intervals) cells.push_back(unknown.coverage ? fmt::format("{:.3f}", *unknown.coverage) : "–");
    table.add(std::move(cells));
  }
  return table;
}

Table quality_table(const std::vector<study::QualityStatistics>& matrices) {
  Table table({{"matrix", Align::left}, {"", Align::left}, {"5 %"}, {"25 %"}, {"median"}, {"75 %"}, {"95 %"}, {"rms over trials"}});
  for (const study::QualityStatistics& matrix : matrices) {
    const auto add = [&](const std::string& first, const char* what, const study::Quantiles& quantiles,
                         const std::string& rms) {
      std::vector<std::string> cells = {first, what};
      for (const double quantile : quantiles) cells.push_back(fmt::format("{:.4g}", quantile));
      cells.push_back(rms);
      table.add(std::move(cells));
    };
    add(words(matrix.matrix), "RJCF", matrix.rjcf, "");
    add("", "ARVF", matrix.arvf, "");
    add("", "rms relative error", matrix.rms_relative_error, fmt::format("{:.4g}", matrix.rms_over_trials));
  }
  return table;
}

std::string speed_text(const study::StudyRun& run) {
  if (run.computed == 0) return "nothing was left to compute";
  return fmt::format("{} trials in {:.3g} s, {:.4g} per second; one solution takes {:.3g} ms", run.computed, run.wall_s,
                     static_cast<double>(run.computed) / run.wall_s, 1e3 * run.solve_s);
}

}  // namespace jointid::report
