#include "cli/stability/stability_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/page/contents.hpp"
#include "report/page/page.hpp"

namespace jointid::cli {
namespace {

/// What double precision can keep at best: 16 − log₁₀(condition).
std::vector<double> allowed(const std::vector<double>& condition) {
  std::vector<double> out;
  for (const double each : condition) out.push_back(std::clamp(16.0 - std::log10(each), 0.0, 16.0));
  return out;
}

report::CurvePlot digits_plot(const stability::Sweep& sweep, const std::vector<stability::Measured>& rows) {
  const DigitTable table = digit_table(rows);
  const bool positive = std::ranges::all_of(table.values, [](double value) { return value > 0.0; });
  report::CurvePlot plot;
  plot.title = "Digits kept";
  plot.x = {sweep.varied, positive && table.values.back() > 100.0 * table.values.front()};
  plot.y = {"digits", false};
  plot.x_values = table.values;
  plot.series.push_back({"16 − log₁₀(condition)", allowed(table.condition), report::Style::reference});
  for (std::size_t way = 0; way < table.ways.size(); ++way) plot.series.push_back({table.ways[way], table.digits[way]});
  return plot;
}

/// Red when a solution was wrong and did not say so.
report::StatusBanner stability_banner(const StabilityReport& report) {
  const auto silent =
      static_cast<std::size_t>(std::ranges::count(report.rows, stability::Honesty::silent_wrong, &stability::Measured::verdict)) +
      report.count.silent_wrong;
  if (silent == 0) return {report::Trust::good, "ok", "No solution was silently wrong."};
  return {report::Trust::bad, "silently wrong", fmt::format("{} solutions were wrong without a warning.", silent)};
}

}  // namespace

std::string stability_report(const StabilityReport& report) {
  report::ReportPage page("Numerical stability", "jointid stability");
  page.status(stability_banner(report));
  page.section("What solutions state of themselves");
  page.add(verdict_table(report));
  page.add(
      report::Text{"Silent wrong: off by more than 10 times the stated bound, without status or warning. "
                   "False alarm: status or warning, though right to 6 digits.",
                   true});
  for (const stability::Sweep& sweep : stability::sweeps()) {
    const auto rows = report.of(sweep.name);
    if (rows.empty()) continue;
    page.section(sweep.title);
    page.add(report::PlotGroup{"", {{"", {digits_plot(sweep, rows)}}}});
    page.add(digits_table(sweep, rows));
    page.add(cost_table(rows));
  }
  page.add(report::Text{
      "Digits: of the unknowns, each times the norm of its column, against the same identification in 50 digits; of the "
      "likelihood, "
      "against the truth. Grey: what the condition allows.",
      true});
  return page.html();
}

}  // namespace jointid::cli
