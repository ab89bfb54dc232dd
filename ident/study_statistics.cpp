#include "ident/study_statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ident/solution.hpp"
#include "ident/study_row.hpp"

namespace jointid::ident {
namespace {

/// Columns of the usable trials, one at a time.
class Columns {
 public:
  explicit Columns(const frf::TableReader& table) : table_(table) {
    for (const double status : raw(StudyColumns::status)) status_.push_back(static_cast<std::uint8_t>(status));
  }

  std::size_t count(Status status) const {
    return static_cast<std::size_t>(std::count(status_.begin(), status_.end(), static_cast<std::uint8_t>(status)));
  }

  std::vector<double> usable(std::size_t column) const {
    std::vector<double> numbers = raw(column);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (status_[i] == static_cast<std::uint8_t>(Status::ok)) numbers[kept++] = numbers[i];
    }
    numbers.resize(kept);
    return numbers;
  }

 private:
  std::vector<double> raw(std::size_t column) const {
    std::vector<double> numbers(table_.rows());
    table_.read(column, 0, numbers);
    return numbers;
  }

  const frf::TableReader& table_;
  std::vector<std::uint8_t> status_;
};

double mean_of(const std::vector<double>& numbers) {
  double sum = 0.0;
  for (const double x : numbers) sum += x;
  return sum / static_cast<double>(numbers.size());
}

double squares_about(const std::vector<double>& numbers, double centre) {
  double sum = 0.0;
  for (const double x : numbers) sum += (x - centre) * (x - centre);
  return sum;
}

Quantiles quantiles_of(std::vector<double> numbers) {
  Quantiles out;
  out.fill(std::numeric_limits<double>::quiet_NaN());
  std::erase_if(numbers, [](double x) { return std::isnan(x); });
  if (numbers.empty()) return out;
  std::sort(numbers.begin(), numbers.end());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double place = study_quantiles[i] * static_cast<double>(numbers.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const double above = numbers[std::min(below + 1, numbers.size() - 1)];
    out[i] = numbers[below] + (place - static_cast<double>(below)) * (above - numbers[below]);
  }
  return out;
}

std::optional<double> coverage_of(const Columns& columns, std::size_t low, double truth) {
  const std::vector<double> lows = columns.usable(low), highs = columns.usable(low + 1);
  std::size_t held = 0, intervals = 0;
  for (std::size_t i = 0; i < lows.size(); ++i) {
    if (std::isnan(lows[i])) continue;
    ++intervals;
    held += lows[i] <= truth && truth <= highs[i];
  }
  if (intervals == 0) return std::nullopt;
  return static_cast<double>(held) / static_cast<double>(intervals);
}

UnknownStatistics unknown_of(const Columns& columns, const frf::TableColumn& column, const StudyColumns& at, std::size_t i) {
  UnknownStatistics out;
  out.name = column.name;
  out.unit = column.unit;
  if (!std::isnan(column.truth)) out.truth = column.truth;
  std::vector<double> numbers = columns.usable(at.value(i));
  const auto n = static_cast<double>(numbers.size());
  out.mean = mean_of(numbers);
  out.std_deviation = std::sqrt(squares_about(numbers, out.mean) / (n - 1.0));
  if (out.truth) {
    out.bias = out.mean - *out.truth;
    out.rms_error = std::sqrt(squares_about(numbers, *out.truth) / n);
    if (at.intervals) out.coverage = coverage_of(columns, at.interval(i), *out.truth);
  }
  out.quantiles = quantiles_of(std::move(numbers));
  return out;
}

}  // namespace

StudyStatistics study_statistics(const Path& file) {
  const frf::TableReader table(file);
  const StudyColumns at = columns_of(table.header());
  const Columns columns(table);
  StudyStatistics out{.trials = table.rows(),
                      .usable = columns.count(Status::ok),
                      .rank_deficient = columns.count(Status::rank_deficient),
                      .no_equations = columns.count(Status::no_equations),
                      .not_converged = columns.count(Status::not_converged),
                      .unknowns = {},
                      .quality = {}};
  for (std::size_t i = 0; i < at.unknowns; ++i) {
    out.unknowns.push_back(unknown_of(columns, table.header().columns[at.value(i)], at, i));
  }
  for (std::size_t k = 0; k < at.judged.size(); ++k) {
    const std::size_t first = at.quality(k);
    const std::vector<double> errors = columns.usable(first + 2);
    out.quality.push_back({.matrix = at.judged[k],
                           .rjcf = quantiles_of(columns.usable(first)),
                           .arvf = quantiles_of(columns.usable(first + 1)),
                           .rms_relative_error = quantiles_of(errors),
                           .rms_over_trials = std::sqrt(squares_about(errors, 0.0) / static_cast<double>(errors.size()))});
  }
  return out;
}

}  // namespace jointid::ident
