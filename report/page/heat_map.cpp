#include "report/page/heat_map.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "tasks/solution_details.hpp"

namespace jointid::report {
namespace {

/// Root mean square of `count` values, `stride` apart from `first`, of those that are there.
double rms_of(const std::vector<double>& values, std::size_t first, std::size_t count, std::size_t stride) {
  double sum = 0.0, there = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = values[first + i * stride];
    if (!std::isfinite(value)) continue;
    sum += value * value;
    there += 1.0;
  }
  return there > 0.0 ? std::sqrt(sum / there) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

HeatMap error_map(const std::string& title, const std::vector<frf::Dof>& responses, const std::vector<frf::Dof>& references,
                  const std::vector<double>& rms_db) {
  HeatMap map{title, frf::names(responses), frf::names(references), rms_db, {}, {}, HeatUnit::decibel};
  const std::size_t rows = responses.size(), columns = references.size();
  for (std::size_t r = 0; r < rows; ++r) map.row_totals.push_back(rms_of(rms_db, r * columns, columns, 1));
  for (std::size_t c = 0; c < columns; ++c) map.column_totals.push_back(rms_of(rms_db, c, rows, columns));
  return map;
}

Table worst_frfs(const HeatMap& map) {
  Table table({{"FRF", Align::left}, {"dB rms"}});
  for (const std::size_t place : tasks::worst_first(map.values)) {
    const std::size_t row = place / map.columns.size(), column = place % map.columns.size();
    table.add({map.rows[row] + " / " + map.columns[column], fmt::format("{:.2f}", map.values[place])});
  }
  return table;
}

}  // namespace jointid::report
