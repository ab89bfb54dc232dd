#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "report/page/escape.hpp"
#include "report/page/tables_html.hpp"

namespace jointid::report {
namespace {

/// Where a class of colour ends and the next begins: dB, and standard deviations of the measured FRF.
constexpr std::array decibel_limits = {0.1, 0.3, 1.0, 3.0, 10.0}, noise_limits = {1.5, 2.0, 3.0, 5.0, 10.0};

const auto& limits_of(HeatUnit unit) { return unit == HeatUnit::decibel ? decibel_limits : noise_limits; }
const char* name_of(HeatUnit unit) { return unit == HeatUnit::decibel ? "dB" : "σ"; }
/// Of more rows or columns those with the largest errors are shown; with more columns than `most_numbers` without numbers.
constexpr std::size_t most_lines = 48, most_numbers = 16;

std::size_t heat_class(double value, HeatUnit unit) {
  const auto& limits = limits_of(unit);
  return static_cast<std::size_t>(std::ranges::upper_bound(limits, value) - limits.begin());
}

std::string decibels(double value) { return fmt::format("{:.{}f}", value, value < 9.995 ? 2 : value < 99.95 ? 1 : 0); }

/// The places of the largest values, at most `most_lines`, in their order; what is not there comes last.
std::vector<std::size_t> worst_lines(const std::vector<double>& totals) {
  std::vector<std::size_t> places(totals.size());
  std::iota(places.begin(), places.end(), 0U);
  if (places.size() <= most_lines) return places;
  const auto size = [&](std::size_t i) { return std::isfinite(totals[i]) ? totals[i] : -1.0; };
  std::ranges::stable_sort(places, std::greater{}, size);
  places.resize(most_lines);
  std::ranges::sort(places);
  return places;
}

std::string heat_cell(double value, const std::string& name, bool numbers, HeatUnit unit) {
  if (!std::isfinite(value)) return "<td class=\"none\"></td>";
  return fmt::format("<td class=\"h{}\" title=\"{}: {} {}\">{}</td>", heat_class(value, unit), html(name), decibels(value), name_of(unit),
                     numbers ? decibels(value) : "");
}

std::string heat_legend(HeatUnit unit) {
  const auto& limits = limits_of(unit);
  std::string out = fmt::format("<p class=\"heat-legend\">{}: <span class=\"h0\">below {}</span>", name_of(unit), limits.front());
  for (std::size_t i = 0; i + 1 < limits.size(); ++i) {
    out += fmt::format("<span class=\"h{}\">{} to {}</span>", i + 1, limits[i], limits[i + 1]);
  }
  return out + fmt::format("<span class=\"h{}\">above {}</span></p>\n", limits.size(), limits.back());
}

std::string heat_titles(const HeatMap& map, const std::vector<std::size_t>& columns) {
  std::string out = "<thead><tr><td></td>";
  for (const std::size_t c : columns) out += "<th scope=\"col\"><span>" + html(map.columns[c]) + "</span></th>";
  return out + "<th scope=\"col\" class=\"total\"><span>all</span></th></tr></thead><tbody>\n";
}

/// A row with its total, which is always a number.
std::string heat_row(const HeatMap& map, std::size_t r, const std::vector<std::size_t>& columns, bool numbers) {
  std::string out = "<tr><th scope=\"row\">" + html(map.rows[r]) + "</th>";
  for (const std::size_t c : columns) {
    out += heat_cell(map.values[r * map.columns.size() + c], map.rows[r] + " / " + map.columns[c], numbers, map.unit);
  }
  return out + heat_cell(map.row_totals[r], map.rows[r], true, map.unit) + "</tr>\n";
}

std::string heat_totals(const HeatMap& map, const std::vector<std::size_t>& columns, bool numbers) {
  std::string out = "<tr class=\"total\"><th scope=\"row\">all</th>";
  for (const std::size_t c : columns) out += heat_cell(map.column_totals[c], map.columns[c], numbers, map.unit);
  return out + "<td></td></tr>\n";
}

std::string heat_cut(std::size_t shown, std::size_t all, const char* what) {
  if (shown == all) return "";
  return fmt::format("<p>The {} of {} {} with the largest errors.</p>\n", shown, all, what);
}

}  // namespace

std::string to_html(const HeatMap& map) {
  const std::vector<std::size_t> rows = worst_lines(map.row_totals), columns = worst_lines(map.column_totals);
  const bool numbers = columns.size() <= most_numbers;
  std::string out = fmt::format("<div class=\"titled\"><div class=\"caption\">{}</div><div class=\"wide\" tabindex=\"0\" aria-label=\"{}\">"
                                "<table class=\"heat{}\">",
                                html(map.title), html(map.title), numbers ? "" : " dense");
  out += heat_titles(map, columns);
  for (const std::size_t r : rows) out += heat_row(map, r, columns, numbers);
  out += heat_totals(map, columns, numbers) + "</tbody></table></div></div>\n" + heat_legend(map.unit);
  return out + heat_cut(rows.size(), map.rows.size(), "responses") + heat_cut(columns.size(), map.columns.size(), "references");
}

}  // namespace jointid::report
