#include <fmt/format.h>

#include "base/statistics.hpp"
#include "report/page/contents.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"
#include "report/series/delay_report.hpp"

namespace jointid::report {
namespace {

CurvePlot information_plot(const tasks::DelayResult& report) {
  CurvePlot plot;
  plot.title = "Mutual information";
  plot.x = {"lag (s)", false};
  plot.y = {"bits", false};
  for (std::size_t k = 0; k < report.information.bits.size(); ++k)
    plot.x_values.push_back(static_cast<double>(k) / report.rate_hz);
  plot.series.push_back({"I", report.information.bits, Style::line});
  plot.level = report.information_bias;
  return plot;
}

CurvePlot neighbours_plot(const tasks::DelayResult& report) {
  CurvePlot plot;
  plot.title = "False neighbours";
  plot.x = {"dimension", false};
  plot.y = {"%", false};
  Series either{"Kennel", {}, Style::line};
  for (const oscillation::FalseNeighbours& row : report.neighbours) {
    plot.x_values.push_back(static_cast<double>(row.dimension));
    either.y.push_back(100.0 * row.either);
  }
  plot.series.push_back(std::move(either));
  return plot;
}

CurvePlot correlation_plot(const tasks::DelayResult& report) {
  CurvePlot plot;
  plot.title = "Correlation sum";
  plot.x = {"radius", true};
  plot.y = {"C", true};
  plot.x_values = report.correlation.radius;
  Series sum{"C(r)", report.correlation.sum, Style::line};
  for (double& y : sum.y) y = y > 0.0 ? y : nan;
  plot.series.push_back(std::move(sum));
  return plot;
}

CurvePlot divergence_plot(const std::string& title, const oscillation::RecordExponent& found) {
  CurvePlot plot;
  plot.title = title;
  plot.x = {"time (s)", false};
  plot.y = {"mean ln distance", false};
  if (!found.curves.empty()) plot.x_values = found.curves.front().time;
  for (const oscillation::DivergenceCurve& curve : found.curves) {
    const std::string radius = curve.radius > 0.0 ? fmt::format(", r = {:.3g}", curve.radius) : "";
    plot.series.push_back({fmt::format("d = {}{}", curve.dimension, radius), curve.mean_log, Style::line});
  }
  return plot;
}

}  // namespace

PlotGroup delay_plots(const tasks::DelayResult& report) {
  return {"", {{"", {information_plot(report), neighbours_plot(report), correlation_plot(report)}}}};
}

PlotGroup divergence_plots(const tasks::DelayResult& report) {
  return {"", {{"", {divergence_plot("Rosenstein", report.rosenstein), divergence_plot("Kantz", report.kantz)}}}};
}

std::string delay_summary(const tasks::DelayResult& report) {
  return fmt::format("{} samples at {:g} Hz.", report.samples, report.rate_hz);
}

std::string delay_page(const tasks::DelayResult& report) {
  ReportPage page(report.file + ", " + report.channel, "jointid series delay");
  page.status(status_banner(report.remarks.empty() ? "ok" : "doubtful", delay_summary(report), report.remarks));
  page.section("Answers");
  page.add(answers_table(report));
  page.add(
      Text{"Exponents are in nats per second; a number only where the curves of d, d + 1 and d + 2 have plateaus with one slope.",
           true});
  if (!report.wolf.empty()) {
    page.add(wolf_table(report));
    page.add(Text{fmt::format("Wolf's exponent, pairs {:.3g} to {:.3g} apart. It comes out of any record; believe it where it stays as the "
                              "evolution grows.",
                              report.wolf_range[0], report.wolf_range[1]),
                  true});
  }
  page.section("Delay and dimension");
  page.add(delay_plots(report));
  page.add(neighbours_table(report));
  page.section("Divergence");
  page.add(divergence_plots(report));
  page.section("Recurrences");
  page.add(recurrences_table(report));
  return page.html();
}

}  // namespace jointid::report
