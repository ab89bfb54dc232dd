#include "report/result/bound_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "ident/likelihood/findings/findings.hpp"
#include "report/text/identifiability_text.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

std::string factor(double value) { return std::isfinite(value) ? fmt::format("{:.2f}", value) : "no longer fixed"; }

/// The unknown whose bound changes most, and by how much.
std::string most_changed(const tasks::BoundChange& change, const std::vector<tasks::UnknownBound>& unknowns) {
  const auto distance = [](double f) { return std::abs(std::log(f)); };
  const auto most = std::ranges::max_element(change.factors, {}, distance);
  return fmt::format("{} {}", unknowns[static_cast<std::size_t>(most - change.factors.begin())].name, factor(*most));
}

std::string changes_text(const char* title, std::vector<tasks::BoundChange> changes, const tasks::BoundReport& report) {
  if (changes.empty()) return "";
  Table table({{"", Align::left}, {"worst bound"}, {"mean"}, {"most changed", Align::left}});
  for (const tasks::BoundChange& change : changes) {
    table.add({change.what, factor(change.worst), factor(change.mean), most_changed(change, report.unknowns)});
  }
  return fmt::format("\n{}: bounds times\n", title) + table.text();
}

}  // namespace

std::string bound_text(const tasks::BoundReport& report) {
  if (report.unknowns.empty()) return "\nINTERRUPTED: the bound was not computed\n";
  Table unknowns({{"name", Align::left}, {"assumed"}, {"std error"}, {"unit", Align::left}, {"relative"}});
  for (const tasks::UnknownBound& unknown : report.unknowns) {
    const bool fixed = std::isfinite(unknown.bound);
    unknowns.add({unknown.name, number(unknown.value), fixed ? fmt::format("{:.3g}", unknown.bound) : "not fixed", unknown.unit,
                  fixed ? percent(unknown.relative) : ""});
  }
  const std::string cut = report.interrupted ? "\nINTERRUPTED: not all changes of the data were examined\n" : "";
  const std::string lines =
      report.lines_looked_at < report.lines
          ? fmt::format("changes of the data: by {} of the {} lines, spread over all\n", report.lines_looked_at, report.lines)
          : "";
  return cut + "\nsmallest standard errors (Cramér–Rao bound) with " + fmt::format("{}", fmt::join(report.variances, ", ")) +
         "\n" + unknowns.text() + "\nleast determined combinations, relative to the assumed values\n" +
         weakest_table(report.weakest).text() + lines + changes_text("without a coordinate", report.without_coordinate, report) +
         changes_text("without a part of the lines", report.without_lines, report) +
         changes_text("with more data", report.with_more, report);
}

}  // namespace jointid::report
