#include "study/study_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "frf/hdf5/table_file.hpp"
#include "ident/result/solution.hpp"
#include "study/study_row.hpp"

namespace jointid::study {
namespace {

/// Rows per reading.
constexpr std::size_t piece = 1 << 16;

void put(double value, Histogram& into) {
  if (std::isnan(value)) return;
  if (value < into.low || value > into.high) {
    ++into.outside;
    return;
  }
  const double place = (value - into.low) / (into.high - into.low) * static_cast<double>(into.counts.size());
  ++into.counts[std::min(static_cast<std::size_t>(place), into.counts.size() - 1)];
}

}  // namespace

std::vector<Histogram> study_histograms(const ident::Path& file, const std::vector<ColumnBins>& columns) {
  const frf::TableReader table(file);
  std::vector<Histogram> histograms;
  for (const ColumnBins& column : columns) {
    histograms.push_back({column.low, column.high, std::vector<std::size_t>(column.bins, 0), 0});
  }
  std::vector<double> status(std::min(piece, table.rows())), values(status.size());
  for (std::size_t first = 0; first < table.rows(); first += piece) {
    const std::size_t count = std::min(piece, table.rows() - first);
    table.read(StudyColumns::status, first, std::span(status).first(count));
    for (std::size_t c = 0; c < columns.size(); ++c) {
      table.read(columns[c].column, first, std::span(values).first(count));
      for (std::size_t i = 0; i < count; ++i) {
        if (is_usable(static_cast<ident::Status>(status[i]))) put(values[i], histograms[c]);
      }
    }
  }
  return histograms;
}

}  // namespace jointid::study
