#pragma once

#include <vector>

#include "records/file/record.hpp"
#include "report/page/contents.hpp"
#include "tasks/frf/run_frf.hpp"

namespace jointid::report {

/// An FRF of records: magnitude, and coherence below it, at most `most` points.
Choice frf_choice(const tasks::FrfRun& run, std::size_t response, std::size_t reference, std::size_t most);

/// The first FRFs, a choice each.
PlotGroup frf_plots(const tasks::FrfRun& run, std::size_t most_choices, std::size_t most);

/// The records themselves, a choice each: the channels below each other, each with its unit, over time. Beside the first force is 1 where
/// a segment is averaged and −1 where it is left out, times the largest force, and its windows: what is drawn is what is averaged.
PlotGroup trace_plots(const tasks::FrfRun& run, const std::vector<records::Record>& records, std::size_t most);

}  // namespace jointid::report
