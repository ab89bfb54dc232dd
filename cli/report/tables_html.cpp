#include "cli/report/tables_html.hpp"

#include <fmt/format.h>

#include <cmath>

#include "cli/report/escape.hpp"

namespace jointid::cli::report {
namespace {

/// Tables of more are written smaller.
constexpr std::size_t most_columns = 8;

/// Wide tables scroll by themselves, not the page.
std::string scrolling(const std::string& table, const char* kind) {
  return fmt::format("<div class=\"{}\" tabindex=\"0\">{}</div>\n", kind, table);
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

std::string to_html(const Table& table, const std::string& title) {
  const auto side = [&](std::size_t i) { return table.columns()[i].align == Align::left ? " class=\"left\"" : ""; };
  std::string out = fmt::format("<table{}>", table.columns().size() > most_columns ? " class=\"many\"" : "");
  if (!title.empty()) out += "<caption>" + html(title) + "</caption>";
  out += "<thead><tr>";
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    out += fmt::format("<th scope=\"col\"{}>{}</th>", side(i), html(table.columns()[i].title));
  }
  out += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows()) {
    out += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      out += i == 0 ? "<th scope=\"row\">" + html(row[i]) + "</th>"
                    : fmt::format("<td{}>{}</td>", side(i), html(row[i]));
    }
    out += "</tr>\n";
  }
  return scrolling(out + "</tbody></table>", title.empty() ? "wide" : "wide beside");
}

std::string to_html(const MatrixTable& matrix) {
  std::string out = "<table class=\"matrix\"><caption>" + html(matrix.title) + "</caption><thead><tr><td></td>";
  for (const std::string& name : matrix.names) out += "<th scope=\"col\">" + html(name) + "</th>";
  out += "</tr></thead><tbody>\n";
  for (std::size_t i = 0; i < matrix.values.size(); ++i) {
    out += "<tr><th scope=\"row\">" + html(matrix.names[i]) + "</th>";
    for (std::size_t j = 0; j < matrix.values[i].size(); ++j) {
      const double value = matrix.values[i][j];
      out += "<td>" + number(value) + (matrix.truth.empty() ? "" : deviation(value, matrix.truth[i][j])) + "</td>";
    }
    out += "</tr>\n";
  }
  return scrolling(out + "</tbody></table>", "wide beside");
}

}  // namespace jointid::cli::report
