#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "report/page/escape.hpp"
#include "report/page/tables_html.hpp"
#include "report/text/table.hpp"

namespace jointid::report {
namespace {

/// Where values of a group of bars stand, in percent of the width; zero is at the same place in all groups.
struct Scale {
  double largest = 0.0;  ///< magnitude of what the group shows
  double zero = 0.0;

  double percent(double value) const {
    return largest > 0.0 ? zero + (100.0 - zero) * value / largest : zero;
  }
};

/// Bars share a scale when their names start alike ("K", "D") and their units are equal.
std::string group_of(const Bar& bar) { return bar.name.substr(0, bar.name.find_first_of("(.[@")) + " " + bar.unit; }

/// What a bar shows: its value, its truth and the ends of its interval, where they are finite.
std::vector<double> shown(const Bar& bar) {
  std::vector<double> values = {bar.value};
  if (bar.truth) values.push_back(*bar.truth);
  if (bar.interval) values.insert(values.end(), bar.interval->begin(), bar.interval->end());
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  return values;
}

std::map<std::string, Scale> scales_of(const std::vector<Bar>& bars) {
  std::map<std::string, Scale> scales;
  bool negative = false;
  for (const Bar& bar : bars) {
    Scale& scale = scales[group_of(bar)];
    for (const double value : shown(bar)) {
      scale.largest = std::max(scale.largest, std::abs(value));
      negative = negative || value < 0.0;
    }
  }
  for (auto& [group, scale] : scales) scale.zero = negative ? 50.0 : 0.0;
  return scales;
}

std::string vertical(const char* kind, double percent, double half_height) {
  return fmt::format("<line class=\"{0}\" x1=\"{1:.2f}%\" x2=\"{1:.2f}%\" y1=\"{2}\" y2=\"{3}\"/>", kind, percent,
                     9.0 - half_height, 9.0 + half_height);
}

std::string picture(const Bar& bar, const Scale& scale) {
  std::string out = "<svg class=\"bar\" aria-hidden=\"true\">";
  const double zero = scale.percent(0.0);
  if (std::isfinite(bar.value)) {
    const double end = scale.percent(bar.value);
    out += fmt::format("<rect x=\"{:.2f}%\" width=\"{:.2f}%\" y=\"4\" height=\"10\"/>", std::min(zero, end),
                       std::abs(end - zero));
  }
  out += vertical("zero", zero, 9.0);
  if (bar.truth) out += vertical("truth", scale.percent(*bar.truth), 7.0);
  if (bar.interval && std::isfinite((*bar.interval)[0]) && std::isfinite((*bar.interval)[1])) {
    const double low = scale.percent((*bar.interval)[0]), high = scale.percent((*bar.interval)[1]);
    out += fmt::format("<line class=\"interval\" x1=\"{:.2f}%\" x2=\"{:.2f}%\" y1=\"9\" y2=\"9\"/>", low, high);
    out += vertical("interval", low, 4.0) + vertical("interval", high, 4.0);
  }
  return out + "</svg>";
}

std::string interval_text(const Bar& bar) {
  return bar.interval ? number((*bar.interval)[0]) + " … " + number((*bar.interval)[1]) : "–";
}

}  // namespace

std::string to_html(const Bars& bars) {
  const auto scales = scales_of(bars.bars);
  const bool intervals = std::ranges::any_of(bars.bars, [](const Bar& bar) { return bar.interval.has_value(); });
  const bool truths = std::ranges::any_of(bars.bars, [](const Bar& bar) { return bar.truth.has_value(); });
  std::string out =
      "<div class=\"wide\" tabindex=\"0\"><table class=\"bars\"><thead><tr><th scope=\"col\">name</th>"
      "<th scope=\"col\">value</th><th scope=\"col\">unit</th>";
  if (intervals) out += "<th scope=\"col\">95 % interval</th>";
  if (truths) out += "<th scope=\"col\">truth</th>";
  out += "<td></td></tr></thead><tbody>\n";
  for (const Bar& bar : bars.bars) {
    out += fmt::format("<tr{}><th scope=\"row\">{}</th><td>{}</td><td class=\"unit\">{}</td>",
                       bar.remark.empty() ? "" : " class=\"doubtful\"", html(bar.name), number(bar.value, bar.error),
                       html(bar.unit));
    if (intervals) out += "<td data-name=\"95 %:\">" + interval_text(bar) + "</td>";
    if (truths) out += "<td data-name=\"truth:\">" + (bar.truth ? number(*bar.truth) : "–") + "</td>";
    out += "<td class=\"picture\">" + picture(bar, scales.at(group_of(bar)));
    if (!bar.remark.empty()) out += "<small>" + html(bar.remark) + "</small>";
    out += "</td></tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

}  // namespace jointid::report
