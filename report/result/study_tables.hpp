#pragma once

#include <string>

#include "report/text/table.hpp"
#include "study/study.hpp"
#include "study/study_statistics.hpp"

/// What a study found, for text and page.
namespace jointid::report {

/// "1000, 998 with an estimate, 2 rank deficient".
std::string trials_text(const study::StudyStatistics& statistics);

/// One row per unknown. Errors are in percent of the true value, or of the mean where none is known; quantiles are those of the
/// relative error.
Table unknowns_table(const study::StudyStatistics& statistics);

/// Quantiles of RJCF, ARVF and rms relative error, three rows per matrix.
Table quality_table(const std::vector<study::QualityStatistics>& matrices);

/// Trials per second and the time of one solution.
std::string speed_text(const study::StudyRun& run);

}  // namespace jointid::report
