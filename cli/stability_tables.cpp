#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/cost_table.hpp"
#include "cli/stability_report.hpp"
#include "cli/words.hpp"

namespace jointid::cli {
namespace {

using stability::Measured;
using stability::Verdict;

/// "qr" of method one or of rows, "two", "direct", "likelihood".
std::string way_of(const Measured& row) { return row.method == "one" || row.method == "rows" ? row.solver : row.method; }

/// Against exact arithmetic where that is known, else against the truth.
double digits_of(const Measured& row) { return std::isnan(row.digits_kept) ? row.digits_true : row.digits_kept; }

std::string one_decimal(double value) { return std::isnan(value) ? "–" : fmt::format("{:.1f}", value); }

std::string outcome_of(const Measured& row) {
  return words(ident::name(row.status)) + (row.warned ? ", warned" : "") + ": " + stability::name(row.verdict);
}

template <class Rows>
std::vector<std::string> verdict_cells(const std::string& what, std::size_t total, const Rows& count) {
  return {what,
          fmt::format("{}", total),
          fmt::format("{}", count(Verdict::right)),
          fmt::format("{}", count(Verdict::told)),
          fmt::format("{}", count(Verdict::silent_wrong)),
          fmt::format("{}", count(Verdict::false_alarm))};
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

Table digits_table(const stability::Sweep& sweep, const std::vector<Measured>& rows) {
  const DigitTable found = digit_table(rows);
  std::vector<Column> columns = {{sweep.varied}, {"condition"}};
  for (const std::string& way : found.ways) columns.push_back({way});
  Table table(std::move(columns));
  for (std::size_t i = 0; i < found.values.size(); ++i) {
    std::vector<std::string> cells = {fmt::format("{:g}", found.values[i]), fmt::format("{:.1e}", found.condition[i])};
    for (const std::vector<double>& digits : found.digits) cells.push_back(one_decimal(digits[i]));
    table.add(std::move(cells));
  }
  return table;
}

Table cost_table(const stability::Sweep& sweep, const std::vector<Measured>& rows) {
  std::vector<CostRow> out;
  for (const Measured& row : rows) {
    const std::string stated = row.digits_stated ? one_decimal(*row.digits_stated) : "–";
    out.push_back({{fmt::format("{:g}", row.value), row.method, row.solver, fmt::format("{}", row.lines), fmt::format("{}", row.unknowns),
                    fmt::format("{}", row.rank), one_decimal(row.digits_true), stated},
                   one_decimal(digits_of(row)),
                   row.seconds,
                   row.bytes,
                   outcome_of(row)});
  }
  return cost_table({{sweep.varied}, {"method", Align::left}, {"solver", Align::left}, {"lines"}, {"unknowns"}, {"rank"}, {"digits true"}, {"stated"}},
                    "digits", "outcome", out);
}

Table verdict_table(const StabilityReport& report) {
  Table table({{"", Align::left}, {"solutions"}, {"right"}, {"told"}, {"silent wrong"}, {"false alarm"}});
  for (const stability::Sweep& sweep : stability::sweeps()) {
    std::vector<Measured> rows = report.of(sweep.name);
    std::erase_if(rows, [](const Measured& row) { return row.verdict == Verdict::not_judged; });
    if (rows.empty()) continue;
    table.add(verdict_cells(sweep.name, rows.size(), [&](Verdict verdict) { return std::ranges::count(rows, verdict, &Measured::verdict); }));
  }
  const stability::Count& count = report.count;
  if (count.scenes > 0) {
    table.add({"random scenes", fmt::format("{}", count.scenes - count.refused), fmt::format("{}", count.right), fmt::format("{}", count.told),
               fmt::format("{}", count.silent_wrong), fmt::format("{}", count.false_alarm)});
  }
  return table;
}

}  // namespace jointid::cli
