#include "cli/problem/reproduction_text.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/problem/reproduction_rows.hpp"
#include "report/json_value.hpp"
#include "report/text/notes.hpp"
#include "report/text/table.hpp"

namespace jointid::cli {
namespace {

using problems::Reproduced;
using problems::TableEntry;

std::string row_text(const ReproductionReport& report, const RowOf& row) {
  const auto line = [&](const char* title, const auto& cell) {
    std::vector<std::string> cells = {title};
    for (std::size_t e = row.first; e < row.last; ++e) cells.push_back(cell(report.table.entries[e], report.results[e]));
    return cells;
  };
  std::vector<report::Column> columns = {{report.table.entries[row.first].row, report::Align::left}};
  for (std::size_t e = row.first; e < row.last; ++e) columns.push_back({report.table.entries[e].column});
  report::Table table(std::move(columns));
  table.add(line(
      "print", [](const TableEntry& entry, const Reproduced&) { return entry.print.text + (entry.print.doubtful ? "?" : ""); }));
  table.add(line("median", [](const TableEntry&, const Reproduced& result) { return four_digits(result.ours.median); }));
  table.add(line("5 %", [](const TableEntry&, const Reproduced& result) { return four_digits(result.ours.low); }));
  table.add(line("95 %", [](const TableEntry&, const Reproduced& result) { return four_digits(result.ours.high); }));
  table.add(
      line("inside", [](const TableEntry&, const Reproduced& result) -> std::string { return result.inside ? "yes" : "NO"; }));
  return "\n" + table.text(0);
}

}  // namespace

std::string table_list() {
  report::Table table({{"table", report::Align::left}, {"what", report::Align::left}, {"entries"}});
  for (const auto& each : problems::thesis_tables()) table.add({each.number, each.title, fmt::format("{}", each.entries.size())});
  return table.text(0);
}

std::string reproduction_text(const ReproductionReport& report) {
  std::string text = fmt::format("Table {}. {}\nprint: one set of random numbers; ours: {} trials of seed {}\n",
                                 report.table.number, report.table.title, report.trials, report.seed);
  for (const RowOf& row : rows_of(report.table.entries)) text += row_text(report, row);
  text += "\n" + verdict_text(count(report)) + "\n";
  text += report::notes_text(report.table.notes);
  return text;
}

std::string reproduction_json(const ReproductionReport& report) {
  const Count counted = count(report);
  report::Json json = {{"table", report.table.number}, {"title", report.table.title}, {"trials", report.trials},
                       {"seed", report.seed},          {"inside", counted.inside},    {"legible", counted.legible},
                       {"doubtful", counted.doubtful}, {"notes", report.table.notes}, {"entries", report::Json::array()}};
  for (std::size_t e = 0; e < report.results.size(); ++e) {
    const TableEntry& entry = report.table.entries[e];
    const Reproduced& result = report.results[e];
    json["entries"].push_back({{"row", entry.row},
                               {"column", entry.column},
                               {"print", entry.print.value},
                               {"doubtful", entry.print.doubtful},
                               {"median", report::value(result.ours.median)},
                               {"q05", report::value(result.ours.low)},
                               {"q95", report::value(result.ours.high)},
                               {"inside", result.inside}});
  }
  return report::json_text(json);
}

std::string reproduction_csv(const ReproductionReport& report) {
  std::string csv = report::csv_line({"table", "row", "column", "print", "doubtful", "median", "q05", "q95", "inside"});
  for (std::size_t e = 0; e < report.results.size(); ++e) {
    const TableEntry& entry = report.table.entries[e];
    const Spread& ours = report.results[e].ours;
    csv += report::csv_line({report.table.number, entry.row, entry.column, entry.print.text,
                             entry.print.doubtful ? "true" : "false", fmt::format("{}", ours.median), fmt::format("{}", ours.low),
                             fmt::format("{}", ours.high), report.results[e].inside ? "true" : "false"});
  }
  return csv;
}

}  // namespace jointid::cli
