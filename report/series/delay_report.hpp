#pragma once

#include <string>

#include "report/page/contents.hpp"
#include "report/text/table.hpp"
#include "tasks/series/delay.hpp"

namespace jointid::report {

/// Mutual information, false neighbours and correlation sum.
PlotGroup delay_plots(const tasks::DelayResult& report);
/// Mean distances of neighbours over time, by Rosenstein and by Kantz.
PlotGroup divergence_plots(const tasks::DelayResult& report);

/// "20000 samples at 1000 Hz."
std::string delay_summary(const tasks::DelayResult& report);

Table neighbours_table(const tasks::DelayResult& report);
Table answers_table(const tasks::DelayResult& report);
/// Wolf's exponent over the time of evolution.
Table wolf_table(const tasks::DelayResult& report);
Table recurrences_table(const tasks::DelayResult& report);

std::string delay_text(const tasks::DelayResult& report);
/// The keys stay. What is not determined is null.
std::string delay_json(const tasks::DelayResult& report);
/// "curve,x,y": a row a point of a curve.
std::string delay_csv(const tasks::DelayResult& report);

/// The page of `jointid series delay`.
std::string delay_page(const tasks::DelayResult& report);

}  // namespace jointid::report
