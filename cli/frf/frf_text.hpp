#pragma once

#include <string>

#include "cli/frf/frf_run.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {

/// Stretches: number, file, begin, force, kept or why not. Of more than forty only those that were left out.
report::Table stretches_table(const FrfRun& run);
/// References: kept, found, effective averages.
report::Table averages_table(const FrfRun& run);
/// FRFs: low, median and high coherence over the lines.
report::Table coherence_table(const FrfRun& run);

/// "H1, 12801 lines from 0 to 12800 Hz, step 1 Hz".
std::string estimate_text(const FrfRun& run);

/// What a user should know before he trusts the numbers, one sentence each.
std::vector<std::string> notes(const FrfRun& run);

std::string frf_text(const FrfRun& run);
std::string frf_json(const FrfRun& run, const FrfArguments& arguments);
/// The stretches.
std::string stretches_csv(const FrfRun& run);

}  // namespace jointid::cli
