#include "report/text/cost_table.hpp"

#include <fmt/format.h>

namespace jointid::report {

Table cost_table(std::vector<Column> way, const std::string& accuracy, const std::string& outcome, const std::vector<CostRow>& rows) {
  way.insert(way.end(), {{accuracy}, {"ms per solve"}, {"kB"}, {outcome, Align::left}});
  Table table(std::move(way));
  for (const CostRow& row : rows) {
    std::vector<std::string> cells = row.way;
    cells.insert(cells.end(), {row.accuracy, fmt::format("{:.3g}", 1e3 * row.seconds),
                               fmt::format("{:.1f}", static_cast<double>(row.bytes) / 1e3), row.outcome});
    table.add(std::move(cells));
  }
  return table;
}

}  // namespace jointid::report
