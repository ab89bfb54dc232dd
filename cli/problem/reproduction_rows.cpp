#include "cli/problem/reproduction_rows.hpp"

#include <fmt/format.h>

#include <cmath>

namespace jointid::cli {

using problems::TableEntry;

std::vector<RowOf> rows_of(const std::vector<TableEntry>& entries) {
  std::vector<RowOf> rows;
  for (std::size_t e = 0; e < entries.size(); ++e) {
    if (e == 0 || entries[e].row != entries[e - 1].row || entries[e].kind != entries[e - 1].kind) rows.push_back({e, e});
    rows.back().last = e + 1;
  }
  return rows;
}

Count count(const ReproductionReport& report) {
  Count counted;
  for (std::size_t e = 0; e < report.results.size(); ++e) {
    if (report.table.entries[e].print.doubtful) {
      ++counted.doubtful;
      continue;
    }
    ++counted.legible;
    counted.inside += report.results[e].inside ? 1U : 0U;
  }
  return counted;
}

std::string verdict_text(const Count& counted) {
  std::string text = fmt::format(
      "{} of {} entries of the print lie inside 5 to 95 %, to its rounding (90 % would be expected of the same problem;\n"
      "entries of one case come from one set of random numbers, so they are in or out together)",
      counted.inside, counted.legible);
  if (counted.doubtful > 0) {
    text += fmt::format(";\n{} more {} doubtful (marked ?) and not counted", counted.doubtful, counted.doubtful == 1 ? "is" : "are");
  }
  return text;
}

std::string four_digits(double value) { return std::isfinite(value) ? fmt::format("{:.4g}", value) : "–"; }

}  // namespace jointid::cli
