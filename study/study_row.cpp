#include "study/study_row.hpp"

#include <algorithm>
#include <sstream>

#include "base/error.hpp"
#include "base/statistics.hpp"

namespace jointid::study {
StudyColumns columns_of(const TrialData& data, bool intervals) {
  StudyColumns columns{.unknowns = data.unknowns.size(), .judged = {}, .intervals = intervals};
  for (const restrictions::Kind kind : data.judged) columns.judged.push_back(restrictions::key(kind));
  return columns;
}

StudyColumns columns_of(const frf::TableHeader& header) {
  StudyColumns columns;
  const auto text = [&](const char* name) {
    const auto found = header.texts.find(name);
    return found == header.texts.end() ? std::string() : found->second;
  };
  std::istringstream(text("unknowns")) >> columns.unknowns;
  std::istringstream judged(text("judged"));
  for (std::string key; judged >> key;) columns.judged.push_back(key);
  columns.intervals = text("intervals") == "yes";
  if (columns.unknowns > 0 && columns.count() == header.columns.size()) return columns;
  throw InputError({.kind = ErrorKind::data,
                    .file = {},
                    .place = "attribute unknowns",
                    .problem = "the table is no study",
                    .remedy = "give the file that `jointid study` wrote"});
}

frf::TableHeader header_of(const TrialData& data, const StudyColumns& columns) {
  frf::TableHeader header;
  header.columns.push_back({"status", "", nan});
  for (const TrialUnknown& unknown : data.unknowns) {
    header.columns.push_back({unknown.name, unknown.unit, unknown.truth.value_or(nan)});
  }
  std::string judged;
  for (const std::string& key : columns.judged) {
    header.columns.push_back({key + " rjcf", "", 1.0});
    header.columns.push_back({key + " arvf", "", 1.0});
    header.columns.push_back({key + " rms_relative_error", "", 0.0});
    judged += (judged.empty() ? "" : " ") + key;
  }
  for (std::size_t i = 0; columns.intervals && i < columns.unknowns; ++i) {
    header.columns.push_back({data.unknowns[i].name + " ci95_low", data.unknowns[i].unit, nan});
    header.columns.push_back({data.unknowns[i].name + " ci95_high", data.unknowns[i].unit, nan});
  }
  header.texts = {{"unknowns", std::to_string(columns.unknowns)},
                  {"judged", judged},
                  {"intervals", columns.intervals ? "yes" : "no"}};
  return header;
}

void fill_row(const Trial& trial, const StudyColumns& columns, std::span<double> row) {
  row[StudyColumns::status] = static_cast<double>(trial.status);
  std::copy(trial.values.begin(), trial.values.end(), row.begin() + 1);
  for (std::size_t k = 0; k < trial.quality.size(); ++k) {
    const std::size_t at = columns.quality(k);
    row[at] = trial.quality[k].rjcf;
    row[at + 1] = trial.quality[k].arvf;
    row[at + 2] = trial.quality[k].rms_relative_error;
  }
  for (std::size_t i = 0; columns.intervals && i < columns.unknowns; ++i) {
    row[columns.interval(i)] = trial.ci95[i] ? (*trial.ci95[i])[0] : nan;
    row[columns.interval(i) + 1] = trial.ci95[i] ? (*trial.ci95[i])[1] : nan;
  }
}

}  // namespace jointid::study
