#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "cli/report/escape.hpp"
#include "cli/report/tables_html.hpp"
#include "cli/table.hpp"

namespace jointid::cli::report {
namespace {

/// From the least to the greatest of what a group of bars shows, zero included.
struct Scale {
  double low = 0.0, high = 0.0;

  void include(double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  double percent(double value) const { return high > low ? 100.0 * (value - low) / (high - low) : 0.0; }
};

/// Bars share a scale when their names start alike ("K", "D") and their units are equal.
std::string group_of(const Bar& bar) { return bar.name.substr(0, bar.name.find_first_of("(.[@")) + " " + bar.unit; }

std::map<std::string, Scale> scales_of(const std::vector<Bar>& bars) {
  std::map<std::string, Scale> scales;
  for (const Bar& bar : bars) {
    Scale& scale = scales[group_of(bar)];
    scale.include(bar.value);
    if (bar.truth) scale.include(*bar.truth);
    for (const double end : bar.interval.value_or(std::array{0.0, 0.0})) scale.include(end);
  }
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
  const bool truths = std::ranges::any_of(bars.bars, [](const Bar& bar) { return bar.truth.has_value(); });
  std::string out =
      "<div class=\"wide\" tabindex=\"0\"><table class=\"bars\"><thead><tr><th scope=\"col\">name</th>"
      "<th scope=\"col\">value</th><th scope=\"col\">unit</th><th scope=\"col\">95 % interval</th>";
  out += truths ? "<th scope=\"col\">truth</th><td></td></tr></thead><tbody>\n" : "<td></td></tr></thead><tbody>\n";
  for (const Bar& bar : bars.bars) {
    out += fmt::format("<tr{}><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td>",
                       bar.remark.empty() ? "" : " class=\"doubtful\"", html(bar.name), number(bar.value),
                       html(bar.unit), interval_text(bar));
    if (truths) out += "<td>" + (bar.truth ? number(*bar.truth) : "–") + "</td>";
    out += "<td class=\"picture\">" + picture(bar, scales.at(group_of(bar)));
    if (!bar.remark.empty()) out += "<small>" + html(bar.remark) + "</small>";
    out += "</td></tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

}  // namespace jointid::cli::report
