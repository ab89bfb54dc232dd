#include "report/page/tables_html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/page/escape.hpp"

namespace jointid::report {
namespace {

/// Tables of more are written smaller.
constexpr std::size_t most_columns = 8;

/// Texts longer than this are broken between words.
constexpr std::size_t longest_unbroken = 48;

/// Wide tables scroll by themselves, not the page; their title stays.
std::string scrolling(const std::string& table, const std::string& title, bool beside) {
  const std::string named = title.empty() ? "" : fmt::format("<div class=\"caption\">{}</div>", html(title));
  return fmt::format("<div class=\"{}\">{}<div class=\"wide\" tabindex=\"0\" aria-label=\"{}\">{}</div></div>\n",
                     beside ? "titled beside" : "titled", named, html(title), table);
}

std::string classes(const Column& column, const std::string& cell) {
  const std::string side = column.align == Align::left ? "left" : "", length = cell.size() > longest_unbroken ? "long" : "";
  if (side.empty() && length.empty()) return "";
  return " class=\"" + side + (side.empty() || length.empty() ? "" : " ") + length + "\"";
}

std::string row_html(const Table& table, const std::vector<std::string>& row) {
  std::string out = "<tr>";
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::string kind = classes(table.columns()[i], row[i]);
    out += i == 0 ? fmt::format("<th scope=\"row\"{}>{}</th>", row[i].size() > longest_unbroken ? " class=\"long\"" : "", html(row[i]))
                  : fmt::format("<td{}>{}</td>", kind, html(row[i]));
  }
  return out + "</tr>\n";
}

std::string deviation(double value, double truth) {
  if (truth == 0.0 || !std::isfinite(value)) return "";
  return fmt::format("<small>{:+.3g} %</small>", 100.0 * (value / truth - 1.0));
}

}  // namespace

std::string to_html(const Text& text) {
  return fmt::format("<p{}>{}</p>\n", text.quiet ? " class=\"quiet\"" : "", html(text.text));
}

std::string to_html(const Facts& facts) {
  std::string out = "<dl>\n";
  for (const auto& [name, value] : facts.rows) {
    out += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", html(name), html(value));
  }
  return out + "</dl>\n";
}

std::string to_html(const Table& table, const std::string& title, std::size_t most) {
  std::string out = fmt::format("<table{}><thead><tr>", table.columns().size() > most_columns ? " class=\"many\"" : "");
  for (const Column& column : table.columns()) {
    out += fmt::format("<th scope=\"col\"{}>{}</th>", classes(column, ""), html(column.title));
  }
  out += "</tr></thead><tbody>\n";
  for (std::size_t row = 0; row < std::min(most, table.rows().size()); ++row) out += row_html(table, table.rows()[row]);
  return scrolling(out + "</tbody></table>", title, !title.empty());
}

std::string to_html(const MatrixTable& matrix) {
  std::string out = "<table class=\"matrix\"><thead><tr><td></td>";
  for (const std::string& name : matrix.names) out += "<th scope=\"col\">" + html(name) + "</th>";
  out += "</tr></thead><tbody>\n";
  for (std::size_t i = 0; i < matrix.values.size(); ++i) {
    out += "<tr><th scope=\"row\">" + html(matrix.names[i]) + "</th>";
    for (std::size_t j = 0; j < matrix.values[i].size(); ++j) {
      const double value = matrix.values[i][j];
      const auto error = matrix.errors.empty() ? std::nullopt : std::optional(matrix.errors[i][j]);
      out += "<td>" + number(value, error) + (matrix.truth.empty() ? "" : deviation(value, matrix.truth[i][j])) + "</td>";
    }
    out += "</tr>\n";
  }
  return scrolling(out + "</tbody></table>", matrix.title, true);
}

}  // namespace jointid::report
