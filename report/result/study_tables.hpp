#pragma once

#include <map>
#include <string>

#include "report/text/table.hpp"
#include "study/study.hpp"
#include "study/study_statistics.hpp"

/// What a study found, for text and page.
namespace jointid::report {

/// What a result file keeps of where it came from, beside what run_study() keeps: scene_hash and jointid_version.
std::map<std::string, std::string> study_texts(const std::string& scene_text);

/// "1000, 998 with an estimate, 2 rank deficient".
std::string trials_text(const study::StudyStatistics& statistics);

/// "hysteretic damping is off by 300 % rms over the trials": of a matrix that a solution does not tell, being off by more than
/// its own size against the truth; without a truth, of unknowns that scatter by more than their mean where most do. Empty: there
/// is none.
std::string study_doubt(const study::StudyStatistics& statistics);

/// One row per unknown. Errors are in percent of the true value, or of the mean where none is known; quantiles are those of the
/// relative error.
Table unknowns_table(const study::StudyStatistics& statistics);

/// Quantiles of RJCF, ARVF and rms relative error, three rows per matrix.
Table quality_table(const std::vector<study::QualityStatistics>& matrices);

/// Trials per second and the time of one solution.
std::string speed_text(const study::StudyRun& run);

}  // namespace jointid::report
