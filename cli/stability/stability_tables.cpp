#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>

#include "cli/stability/stability_report.hpp"
#include "report/text/cost_table.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {
namespace {

using stability::Measured;
using stability::Honesty;

/// "qr" of method one or of rows, "two", "direct", "newton", "likelihood".
std::string way_of(const Measured& row) { return row.method == "one" || row.method == "rows" ? row.solver : row.method; }

/// Against exact arithmetic where that is known, else against the truth.
double digits_of(const Measured& row) { return std::isnan(row.digits_kept) ? row.digits_true : row.digits_kept; }

std::string one_decimal(double value) { return std::isnan(value) ? "–" : fmt::format("{:.1f}", value); }

/// "8.2 … 15.5", of what is there.
std::string range(const std::vector<Measured>& rows, const std::function<double(const Measured&)>& number) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Measured& row : rows) {
    const double each = number(row);
    if (std::isnan(each)) continue;
    low = std::min(low, each);
    high = std::max(high, each);
  }
  if (low > high) return "–";
  return low == high ? fmt::format("{:.4g}", low)
                     : fmt::format("{:.4g} … {:.4g}", std::round(10.0 * low) / 10.0, std::round(10.0 * high) / 10.0);
}

/// "14 right, 2 told".
std::string outcomes(const std::vector<Measured>& rows) {
  std::vector<std::string> words;
  for (const Honesty verdict : {Honesty::right, Honesty::told, Honesty::silent_wrong, Honesty::false_alarm}) {
    const auto count = std::ranges::count(rows, verdict, &Measured::verdict);
    if (count > 0) words.push_back(fmt::format("{} {}", count, stability::name(verdict)));
  }
  return words.empty() ? "–" : fmt::format("{}", fmt::join(words, ", "));
}

/// One way over all values of a sweep: median time, most memory.
report::CostRow cost_of(std::vector<Measured> rows) {
  const auto stated = [](const Measured& row) { return row.digits_stated.value_or(std::nan("")); };
  report::CostRow out;
  out.way = {rows.front().method,
             rows.front().solver,
             range(rows, [](const Measured& row) { return static_cast<double>(row.lines); }),
             fmt::format("{}", rows.back().unknowns),
             range(rows, [](const Measured& row) { return row.digits_true; }),
             range(rows, stated)};
  out.accuracy = range(rows, digits_of);
  out.outcome = outcomes(rows);
  for (const Measured& row : rows) out.bytes = std::max(out.bytes, row.bytes);
  std::ranges::sort(rows, {}, &Measured::seconds);
  out.seconds = rows[rows.size() / 2].seconds;
  return out;
}

template <class Rows>
std::vector<std::string> verdict_cells(const std::string& what, std::size_t total, const Rows& count) {
  return {what,
          fmt::format("{}", total),
          fmt::format("{}", count(Honesty::right)),
          fmt::format("{}", count(Honesty::told)),
          fmt::format("{}", count(Honesty::silent_wrong)),
          fmt::format("{}", count(Honesty::false_alarm))};
}

}  // namespace

std::vector<Measured> StabilityReport::of(const std::string& sweep) const {
  std::vector<Measured> out;
  std::ranges::copy_if(rows, std::back_inserter(out), [&](const Measured& row) { return row.sweep == sweep; });
  return out;
}

DigitTable digit_table(const std::vector<Measured>& rows) {
  DigitTable out;
  for (const Measured& row : rows) {
    if (std::ranges::find(out.values, row.value) == out.values.end()) {
      out.values.push_back(row.value);
      out.condition.push_back(row.condition);
    }
    if (std::ranges::find(out.ways, way_of(row)) == out.ways.end()) out.ways.push_back(way_of(row));
  }
  out.digits.assign(out.ways.size(), std::vector<double>(out.values.size(), std::numeric_limits<double>::quiet_NaN()));
  for (const Measured& row : rows) {
    const auto way = static_cast<std::size_t>(std::ranges::find(out.ways, way_of(row)) - out.ways.begin());
    const auto value = static_cast<std::size_t>(std::ranges::find(out.values, row.value) - out.values.begin());
    out.digits[way][value] = digits_of(row);
  }
  return out;
}

report::Table digits_table(const stability::Sweep& sweep, const std::vector<Measured>& rows) {
  const DigitTable found = digit_table(rows);
  std::vector<report::Column> columns = {{sweep.varied}, {"condition"}};
  for (const std::string& way : found.ways) columns.push_back({way});
  report::Table table(std::move(columns));
  for (std::size_t i = 0; i < found.values.size(); ++i) {
    std::vector<std::string> cells = {fmt::format("{:g}", found.values[i]), fmt::format("{:.1e}", found.condition[i])};
    for (const std::vector<double>& digits : found.digits) cells.push_back(one_decimal(digits[i]));
    table.add(std::move(cells));
  }
  return table;
}

report::Table cost_table(const std::vector<Measured>& rows) {
  std::vector<report::CostRow> out;
  for (const std::string& way : digit_table(rows).ways) {
    std::vector<Measured> of_way;
    std::ranges::copy_if(rows, std::back_inserter(of_way), [&](const Measured& row) { return way_of(row) == way; });
    out.push_back(cost_of(of_way));
  }
  return report::cost_table(
      {{"method", report::Align::left}, {"solver", report::Align::left}, {"lines"}, {"unknowns"}, {"digits true"}, {"stated"}},
      "digits", "outcome", out);
}

report::Table verdict_table(const StabilityReport& report) {
  report::Table table({{"", report::Align::left}, {"solutions"}, {"right"}, {"told"}, {"silent wrong"}, {"false alarm"}});
  for (const stability::Sweep& sweep : stability::sweeps()) {
    std::vector<Measured> rows = report.of(sweep.name);
    std::erase_if(rows, [](const Measured& row) { return row.verdict == Honesty::not_judged; });
    if (rows.empty()) continue;
    table.add(verdict_cells(sweep.name, rows.size(),
                            [&](Honesty verdict) { return std::ranges::count(rows, verdict, &Measured::verdict); }));
  }
  const stability::Count& count = report.count;
  if (count.scenes > 0) {
    table.add({"random scenes", fmt::format("{}", count.scenes - count.refused), fmt::format("{}", count.right),
               fmt::format("{}", count.told), fmt::format("{}", count.silent_wrong), fmt::format("{}", count.false_alarm)});
  }
  return table;
}

}  // namespace jointid::cli
