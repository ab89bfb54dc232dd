#pragma once

#include <string>

#include "study/study.hpp"
#include "study/study_statistics.hpp"

namespace jointid::cli {

/// A finished study as the reports show it.
struct StudyReport {
  std::string title;
  std::string file;
  std::uint64_t seed = 1;
  study::StudyRun run;
  study::StudyStatistics statistics;
  std::vector<std::string> notes{};
};

/// Tables of unknowns and of figures of merit, for reading. Errors are relative to the true value, or to the mean where none
/// is known.
std::string study_text(const StudyReport& report);

/// The same as JSON with the keys trials, seed, file, notes, unknowns, quality and runtime_s; SI units, null where there is nothing.
std::string study_json(const StudyReport& report);

/// The unknowns as CSV: name, unit, truth, mean, bias, std, rms_error, q05 … q95, coverage; empty where there is nothing.
std::string study_csv(const StudyReport& report);

}  // namespace jointid::cli
