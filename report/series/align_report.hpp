#pragma once

#include <string>
#include <vector>

#include "report/page/contents.hpp"
#include "report/text/table.hpp"
#include "tasks/series/align.hpp"

namespace jointid::report {

/// Channels in which the motion of this frequency is not what is seen most: their delays mean little.
std::vector<std::string> align_remarks(const tasks::AlignResult& report);
Table delays_table(const tasks::AlignResult& report);
/// Three periods of every channel over its amplitude, as measured and aligned.
PlotGroup align_plots(const tasks::AlignResult& report);
/// "'beam' is 0.0031 s late against slider."
std::string align_summary(const tasks::AlignResult& report);

/// For people.
std::string align_text(const tasks::AlignResult& report);
/// The keys stay.
std::string align_json(const tasks::AlignResult& report);
/// The record without the delays: "time [s],NAME [unit],…" and a row a sample; missing samples are empty cells.
std::string align_csv(const tasks::AlignResult& report);
/// The page of `jointid series align`.
std::string align_page(const tasks::AlignResult& report);

}  // namespace jointid::report
