#include "cli/study_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "cli/table.hpp"

namespace jointid::cli {
namespace {

std::string optional_number(const std::optional<double>& value) { return value ? number(*value) : "–"; }

/// In percent of `scale`, which is not 0.
std::string percent(double value, double scale) {
  const double share = 100.0 * value / std::abs(scale);
  return std::isfinite(share) ? fmt::format("{:.3g}", share) : "–";
}

std::string percent(const std::optional<double>& value, double scale) { return value ? percent(*value, scale) : "–"; }

std::string head(const StudyReport& report) {
  const ident::StudyStatistics& s = report.statistics;
  Table table({{"", Align::left}, {"", Align::left}});
  std::string failures;
  if (s.rank_deficient > 0) failures += fmt::format(", {} rank deficient", s.rank_deficient);
  if (s.no_equations > 0) failures += fmt::format(", {} without equations", s.no_equations);
  if (s.not_converged > 0) failures += fmt::format(", {} not converged", s.not_converged);
  table.add({"trials", fmt::format("{}, {} with an estimate{}", s.trials, s.usable, failures)});
  table.add({"seed", fmt::format("{}", report.seed)});
  table.add({"all results", report.file});
  return (report.title.empty() ? "" : report.title + "\n") + table.text();
}

std::string unknowns_text(const ident::StudyStatistics& statistics) {
  Table table({{"name", Align::left}, {"true value"}, {"mean"}, {"unit", Align::left}, {"bias %"}, {"std %"}, {"rms error %"},
               {"5 %"}, {"25 %"}, {"median %"}, {"75 %"}, {"95 %"}, {"coverage"}});
  for (const ident::UnknownStatistics& unknown : statistics.unknowns) {
    const double centre = unknown.truth.value_or(unknown.mean);
    std::vector<std::string> cells = {unknown.name, optional_number(unknown.truth), number(unknown.mean), unknown.unit,
                                      percent(unknown.bias, centre), percent(unknown.std_deviation, centre),
                                      percent(unknown.rms_error, centre)};
    for (const double quantile : unknown.quantiles) cells.push_back(percent(quantile - centre, centre));
    cells.push_back(unknown.coverage ? fmt::format("{:.3f}", *unknown.coverage) : "–");
    table.add(std::move(cells));
  }
  return "\nunknowns; quantiles of the relative error\n" + table.text();
}

std::string quality_text(const std::vector<ident::QualityStatistics>& matrices) {
  if (matrices.empty()) return "";
  Table table({{"matrix", Align::left}, {"", Align::left}, {"5 %"}, {"25 %"}, {"median"}, {"75 %"}, {"95 %"}, {"rms over trials"}});
  for (const ident::QualityStatistics& matrix : matrices) {
    std::string name = matrix.matrix;
    for (char& c : name) c = c == '_' ? ' ' : c;
    const auto add = [&](const std::string& first, const char* what, const ident::Quantiles& quantiles,
                         const std::string& rms) {
      std::vector<std::string> cells = {first, what};
      for (const double quantile : quantiles) cells.push_back(fmt::format("{:.4g}", quantile));
      cells.push_back(rms);
      table.add(std::move(cells));
    };
    add(name, "RJCF", matrix.rjcf, "");
    add("", "ARVF", matrix.arvf, "");
    add("", "rms relative error", matrix.rms_relative_error, fmt::format("{:.4g}", matrix.rms_over_trials));
  }
  return "\nquantiles against the truth\n" + table.text();
}

std::string time_text(const ident::StudyRun& run) {
  if (run.computed == 0) return "\nnothing was left to compute\n";
  return fmt::format("\n{} trials in {:.3g} s, {:.4g} per second; one solution takes {:.3g} ms\n", run.computed, run.wall_s,
                     static_cast<double>(run.computed) / run.wall_s, 1e3 * run.solve_s);
}

}  // namespace

std::string study_text(const StudyReport& report) {
  return head(report) + unknowns_text(report.statistics) + quality_text(report.statistics.quality) + time_text(report.run);
}

std::string study_csv(const StudyReport& report) {
  const auto exact = [](const std::optional<double>& value) {
    return value && std::isfinite(*value) ? fmt::format("{}", *value) : std::string();
  };
  std::string csv = csv_line({"name", "unit", "truth", "mean", "bias", "std", "rms_error", "q05", "q25", "q50", "q75", "q95",
                              "coverage"});
  for (const ident::UnknownStatistics& unknown : report.statistics.unknowns) {
    std::vector<std::string> fields = {unknown.name,        unknown.unit,
                                       exact(unknown.truth), exact(unknown.mean),
                                       exact(unknown.bias),  exact(unknown.std_deviation),
                                       exact(unknown.rms_error)};
    for (const double quantile : unknown.quantiles) fields.push_back(exact(quantile));
    fields.push_back(exact(unknown.coverage));
    csv += csv_line(fields);
  }
  return csv;
}

}  // namespace jointid::cli
