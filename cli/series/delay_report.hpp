#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/series/series_arguments.hpp"
#include "cli/text/progress.hpp"
#include "report/text/table.hpp"
#include "series/delay/correlation.hpp"
#include "series/delay/divergence.hpp"
#include "series/delay/false_neighbours.hpp"
#include "series/delay/mutual_information.hpp"
#include "series/delay/recurrence.hpp"

namespace jointid::cli {

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

DelayReport delay_report(const SeriesDelayArguments& arguments, Progress& progress);

report::Table neighbours_table(const DelayReport& report);
report::Table answers_table(const DelayReport& report);
report::Table recurrences_table(const DelayReport& report);

std::string delay_text(const DelayReport& report);
/// The keys stay. What is not determined is null.
std::string delay_json(const DelayReport& report);
/// "curve,x,y": a row a point of a curve.
std::string delay_csv(const DelayReport& report);

}  // namespace jointid::cli

namespace jointid::cli {

/// The page of `jointid series delay`.
std::string delay_page(const DelayReport& report);

}  // namespace jointid::cli
