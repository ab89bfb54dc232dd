#include "report/result/study_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "report/result/study_tables.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

std::string head(const tasks::StudyResult& result) {
  Table table({{"", Align::left}, {"", Align::left}});
  table.add({"trials", trials_text(result.statistics)});
  if (const std::string doubt = tasks::study_doubt(result.statistics); !doubt.empty()) table.add({"doubtful", doubt});
  table.add({"seed", fmt::format("{}", result.seed)});
  table.add({"all results", result.file});
  for (const std::string& note : result.notes) table.add({"note", note});
  return (result.title.empty() ? "" : result.title + "\n") + table.text();
}

std::string quality_text(const std::vector<study::QualityStatistics>& matrices) {
  return matrices.empty() ? "" : "\nquantiles against the truth\n" + quality_table(matrices).text();
}

}  // namespace

std::string study_text(const tasks::StudyResult& result) {
  return head(result) + "\nunknowns; quantiles of the relative error\n" + unknowns_table(result.statistics).text() +
         quality_text(result.statistics.quality) + "\n" + speed_text(result.run) + "\n";
}

std::string study_csv(const tasks::StudyResult& result) {
  const auto exact = [](const std::optional<double>& value) {
    return value && std::isfinite(*value) ? fmt::format("{}", *value) : std::string();
  };
  std::string csv =
      csv_line({"name", "unit", "truth", "mean", "bias", "std", "rms_error", "q05", "q25", "q50", "q75", "q95", "coverage"});
  for (const study::UnknownStatistics& unknown : result.statistics.unknowns) {
    std::vector<std::string> fields = {unknown.name,
                                       unknown.unit,
                                       exact(unknown.truth),
                                       exact(unknown.mean),
                                       exact(unknown.bias),
                                       exact(unknown.std_deviation),
                                       exact(unknown.rms_error)};
    for (const double quantile : unknown.quantiles) fields.push_back(exact(quantile));
    fields.push_back(exact(unknown.coverage));
    csv += csv_line(fields);
  }
  return csv;
}

}  // namespace jointid::report
