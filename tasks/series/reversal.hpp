#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ident/result/control.hpp"
#include "oscillation/measurement/reversal.hpp"
#include "records/file/read_series.hpp"

namespace jointid::tasks {

/// The stiffness of a contact from the slopes of its force after reversals, as it is asked for.
struct ReversalTask {
  std::filesystem::path file;
  std::string displacement, force;  ///< columns, m and N
  oscillation::ReversalOptions options;
  std::optional<double> rate_hz;
};

/// The stiffness, and the samples it was found from: those that are there in both channels.
struct ReversalResult {
  std::string file;
  std::vector<double> displacement, force;
  std::size_t missing = 0;  ///< samples that are left out
  oscillation::ReversalStiffness found;
};

/// Reads the channels and fits the slopes. Throws InputError, and Interrupted before the fit.
ReversalResult run_reversal(const ReversalTask& task, const ident::Control& control = {});

/// The same of a record in memory with the channels displacement and force; the task's file, columns and rate are not used.
ReversalResult run_reversal(const ReversalTask& task, const records::SeriesRecord& record);

}  // namespace jointid::tasks
