#include "cli/problem/reproduction_page.hpp"

#include <fmt/format.h>

#include "cli/problem/reproduction_rows.hpp"
#include "report/page/contents.hpp"
#include "report/page/page.hpp"

namespace jointid::cli {
namespace {

report::ComparedCell cell_of(const problems::TableEntry& entry, const problems::Reproduced& result) {
  const report::InRange judged = result.inside ? report::InRange::inside : report::InRange::outside;
  return {entry.print.text, four_digits(result.ours.median), four_digits(result.ours.low), four_digits(result.ours.high),
          entry.print.doubtful ? report::InRange::doubtful : judged};
}

/// Consecutive rows over the same columns stand in one table.
std::vector<report::ComparedTable> tables_of(const ReproductionReport& report) {
  std::vector<report::ComparedTable> tables;
  for (const RowOf& row : rows_of(report.table.entries)) {
    std::vector<std::string> titles;
    std::vector<report::ComparedCell> cells;
    for (std::size_t e = row.first; e < row.last; ++e) {
      titles.push_back(report.table.entries[e].column);
      cells.push_back(cell_of(report.table.entries[e], report.results[e]));
    }
    if (tables.empty() || tables.back().titles != titles) tables.push_back({titles, {}});
    tables.back().rows.emplace_back(report.table.entries[row.first].row, std::move(cells));
  }
  return tables;
}

}  // namespace

std::string reproduction_report(const ReproductionReport& report) {
  report::ReportPage page(fmt::format("Table {}. {}", report.table.number, report.table.title),
                          "jointid compare --reproduce " + report.table.number);
  page.section("Print and ours");
  page.add(report::Text{verdict_text(count(report)) + "."});
  for (const report::ComparedTable& table : tables_of(report)) page.add(table);
  page.add(report::Text{
      fmt::format("Of each entry the print of Y. Ren's thesis (1992), which comes from one set of random numbers, and below "
                  "it (bold) the median, and the 5 and 95 % quantiles of {} trials of seed {}.",
                  report.trials, report.seed),
      true});
  if (report.table.notes.empty()) return page.html();
  page.section("Notes");
  for (const std::string& note : report.table.notes) page.add(report::Text{note});
  return page.html();
}

}  // namespace jointid::cli
