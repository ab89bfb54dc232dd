#pragma once

#include <string>

#include "tasks/study/run_study.hpp"

namespace jointid::report {

/// Tables of unknowns and of figures of merit, for reading. Errors are relative to the true value, or to the mean where none
/// is known.
std::string study_text(const tasks::StudyResult& result);

/// The same as JSON with the keys trials, seed, file, notes, unknowns, quality and runtime_s; SI units, null where there is
/// nothing.
std::string study_json(const tasks::StudyResult& result);

/// The unknowns as CSV: name, unit, truth, mean, bias, std, rms_error, q05 … q95, coverage; empty where there is nothing.
std::string study_csv(const tasks::StudyResult& result);

}  // namespace jointid::report
