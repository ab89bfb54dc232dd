#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ident/result/control.hpp"
#include "report/page/contents.hpp"
#include "report/series/delay_task.hpp"
#include "report/text/table.hpp"
#include "series/delay/correlation.hpp"
#include "series/delay/divergence.hpp"
#include "series/delay/false_neighbours.hpp"
#include "series/delay/mutual_information.hpp"
#include "series/delay/recurrence.hpp"

namespace jointid::report {

/// What the tools of series/delay/ say of one channel.
struct DelayReport {
  std::string file, channel, unit;
  double rate_hz = 0.0;
  std::size_t samples = 0;
  series::InformationCurve information;
  double information_bias = 0.0;  ///< bits
  std::vector<series::FalseNeighbours> neighbours;
  series::Embedding embedding;  ///< used below
  bool delay_given = false, dimension_given = false;
  std::size_t theiler = 0;
  series::CorrelationDimension correlation;
  series::RecordExponent rosenstein, kantz;
  double recurrence_radius = 0.0;
  std::vector<series::RecurrentPeriod> recurrences;
  std::vector<std::string> remarks;
};

/// Reads the channel and asks one tool after another. Throws InputError, and Interrupted.
DelayReport delay_report(const DelayTask& task, const ident::Control& control);

/// Mutual information, false neighbours and correlation sum.
PlotGroup delay_plots(const DelayReport& report);
/// Mean distances of neighbours over time, by Rosenstein and by Kantz.
PlotGroup divergence_plots(const DelayReport& report);

/// "20000 samples at 1000 Hz."
std::string delay_summary(const DelayReport& report);

Table neighbours_table(const DelayReport& report);
Table answers_table(const DelayReport& report);
Table recurrences_table(const DelayReport& report);

std::string delay_text(const DelayReport& report);
/// The keys stay. What is not determined is null.
std::string delay_json(const DelayReport& report);
/// "curve,x,y": a row a point of a curve.
std::string delay_csv(const DelayReport& report);

/// The page of `jointid series delay`.
std::string delay_page(const DelayReport& report);

}  // namespace jointid::report
