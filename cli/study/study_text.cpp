#include "cli/study/study_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "report/result/study_tables.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {
namespace {

using report::quality_table;
using report::speed_text;
using report::trials_text;
using report::unknowns_table;

std::string head(const StudyReport& report) {
  report::Table table({{"", report::Align::left}, {"", report::Align::left}});
  table.add({"trials", trials_text(report.statistics)});
  if (const std::string doubt = report::study_doubt(report.statistics); !doubt.empty()) table.add({"doubtful", doubt});
  table.add({"seed", fmt::format("{}", report.seed)});
  table.add({"all results", report.file});
  for (const std::string& note : report.notes) table.add({"note", note});
  return (report.title.empty() ? "" : report.title + "\n") + table.text();
}

std::string quality_text(const std::vector<study::QualityStatistics>& matrices) {
  return matrices.empty() ? "" : "\nquantiles against the truth\n" + quality_table(matrices).text();
}

}  // namespace

std::string study_text(const StudyReport& report) {
  return head(report) + "\nunknowns; quantiles of the relative error\n" + unknowns_table(report.statistics).text() +
         quality_text(report.statistics.quality) + "\n" + speed_text(report.run) + "\n";
}

std::string study_csv(const StudyReport& report) {
  const auto exact = [](const std::optional<double>& value) {
    return value && std::isfinite(*value) ? fmt::format("{}", *value) : std::string();
  };
  std::string csv = report::csv_line(
      {"name", "unit", "truth", "mean", "bias", "std", "rms_error", "q05", "q25", "q50", "q75", "q95", "coverage"});
  for (const study::UnknownStatistics& unknown : report.statistics.unknowns) {
    std::vector<std::string> fields = {unknown.name,        unknown.unit,
                                       exact(unknown.truth), exact(unknown.mean),
                                       exact(unknown.bias),  exact(unknown.std_deviation),
                                       exact(unknown.rms_error)};
    for (const double quantile : unknown.quantiles) fields.push_back(exact(quantile));
    fields.push_back(exact(unknown.coverage));
    csv += report::csv_line(fields);
  }
  return csv;
}

}  // namespace jointid::cli
