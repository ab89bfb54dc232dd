#include <fmt/format.h>

#include "report/page/escape.hpp"
#include "report/page/tables_html.hpp"

namespace jointid::report {
namespace {

struct Mark {
  const char *kind, *sign, *words;
};

Mark mark_of(InRange verdict) {
  switch (verdict) {
    case InRange::inside: return {"inside", "✓", "inside"};
    case InRange::outside: return {"outside", "✗", "outside"};
    case InRange::doubtful: break;
  }
  return {"unsure", "?", "doubtful print"};
}

std::string cell_html(const ComparedCell& cell) {
  const Mark mark = mark_of(cell.verdict);
  return fmt::format("<td class=\"{}\">{} <span title=\"{}\">{}</span><strong>{}</strong><small>{}…<br>{}</small></td>",
                     mark.kind, html(cell.published), mark.words, mark.sign, html(cell.ours), html(cell.low), html(cell.high));
}

}  // namespace

std::string to_html(const ComparedTable& table) {
  std::string out = "<div class=\"wide\" tabindex=\"0\"><table class=\"compared\"><thead><tr><td></td>";
  for (const std::string& title : table.titles) out += "<th scope=\"col\">" + html(title) + "</th>";
  out += "</tr></thead><tbody>\n";
  for (const auto& [name, cells] : table.rows) {
    out += "<tr><th scope=\"row\">" + html(name) + "</th>";
    for (const ComparedCell& cell : cells) out += cell_html(cell);
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

}  // namespace jointid::report
