#include "study/study_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "study/study_row.hpp"
#include "study/usable_columns.hpp"

namespace jointid::study {
namespace {

/// In the order of the trials, so that rounding does not depend on the pieces.
double sum_of(const ColumnPass& column) {
  double sum = 0.0;
  column([&](std::span<const double> numbers) {
    for (const double x : numbers) sum += x;
  });
  return sum;
}

double squares_about(const ColumnPass& column, double centre) {
  double sum = 0.0;
  column([&](std::span<const double> numbers) {
    for (const double x : numbers) sum += (x - centre) * (x - centre);
  });
  return sum;
}

Quantiles quantiles_of(const ColumnPass& column) {
  Quantiles out;
  out.fill(std::numeric_limits<double>::quiet_NaN());
  const std::size_t count = count_numbers(column);
  if (count == 0) return out;
  std::vector<std::size_t> places;
  for (const double level : study_quantiles) {
    const auto below = static_cast<std::size_t>(level * static_cast<double>(count - 1));
    places.insert(places.end(), {below, std::min(below + 1, count - 1)});
  }
  const std::vector<double> numbers = order_statistics(column, places);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double place = study_quantiles[i] * static_cast<double>(count - 1);
    out[i] = numbers[2 * i] + (place - static_cast<double>(places[2 * i])) * (numbers[2 * i + 1] - numbers[2 * i]);
  }
  return out;
}

std::optional<double> coverage_of(const UsableColumns& columns, std::size_t low, double truth) {
  std::size_t held = 0, intervals = 0;
  columns.each_piece({low, low + 1}, [&](std::span<const std::vector<double>> ends) {
    for (std::size_t i = 0; i < ends[0].size(); ++i) {
      if (std::isnan(ends[0][i])) continue;
      ++intervals;
      held += ends[0][i] <= truth && truth <= ends[1][i];
    }
  });
  if (intervals == 0) return std::nullopt;
  return static_cast<double>(held) / static_cast<double>(intervals);
}

UnknownStatistics unknown_of(const UsableColumns& columns, const frf::TableColumn& column, const StudyColumns& at, std::size_t i,
                             double n) {
  UnknownStatistics out;
  out.name = column.name;
  out.unit = column.unit;
  if (!std::isnan(column.truth)) out.truth = column.truth;
  const ColumnPass numbers = columns.pass(at.value(i));
  out.mean = sum_of(numbers) / n;
  out.std_deviation = std::sqrt(squares_about(numbers, out.mean) / (n - 1.0));
  if (out.truth) {
    out.bias = out.mean - *out.truth;
    out.rms_error = std::sqrt(squares_about(numbers, *out.truth) / n);
    if (at.intervals) out.coverage = coverage_of(columns, at.interval(i), *out.truth);
  }
  out.quantiles = quantiles_of(numbers);
  return out;
}

}  // namespace

StudyStatistics study_statistics(const ident::Path& file) {
  const frf::TableReader table(file);
  const StudyColumns at = columns_of(table.header());
  const UsableColumns columns(table);
  StudyStatistics out{.trials = table.rows(),
                      .usable = columns.count(ident::Status::ok) + columns.count(ident::Status::doubtful),
                      .rank_deficient = columns.count(ident::Status::rank_deficient),
                      .no_equations = columns.count(ident::Status::no_equations),
                      .not_converged = columns.count(ident::Status::not_converged),
                      .doubtful = columns.count(ident::Status::doubtful),
                      .poor_fit = columns.count(ident::Status::poor_fit),
                      .unknowns = {},
                      .quality = {}};
  const auto n = static_cast<double>(out.usable);
  for (std::size_t i = 0; i < at.unknowns; ++i) {
    out.unknowns.push_back(unknown_of(columns, table.header().columns[at.value(i)], at, i, n));
  }
  for (std::size_t k = 0; k < at.judged.size(); ++k) {
    const std::size_t first = at.quality(k);
    const ColumnPass errors = columns.pass(first + 2);
    out.quality.push_back({.matrix = at.judged[k],
                           .rjcf = quantiles_of(columns.pass(first)),
                           .arvf = quantiles_of(columns.pass(first + 1)),
                           .rms_relative_error = quantiles_of(errors),
                           .rms_over_trials = std::sqrt(squares_about(errors, 0.0) / n)});
  }
  return out;
}

}  // namespace jointid::study
