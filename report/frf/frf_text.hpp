#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "report/text/table.hpp"
#include "tasks/frf/run_frf.hpp"

namespace jointid::report {

/// Stretches: number, file, begin, force, kept or why not. Of more than forty only those that were left out.
Table stretches_table(const tasks::FrfRun& run);
/// References: kept, found, effective averages.
Table averages_table(const tasks::FrfRun& run);
/// FRFs: low, median and high coherence over the lines.
Table coherence_table(const tasks::FrfRun& run);

/// "H1, 12801 lines from 0 to 12800 Hz, step 1 Hz".
std::string estimate_text(const tasks::FrfRun& run);

/// What a user should know before he trusts the numbers, one sentence each.
std::vector<std::string> notes(const tasks::FrfRun& run);

std::string frf_text(const tasks::FrfRun& run);
/// The same as JSON; the keys stay. `output`: the file of the FRFs, where one is written.
std::string frf_json(const tasks::FrfRun& run, const std::optional<std::filesystem::path>& output);
/// The stretches.
std::string stretches_csv(const tasks::FrfRun& run);

}  // namespace jointid::report
