#include "cli/pod/pod_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/statistics.hpp"
#include "report/page/contents.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"

namespace jointid::cli {
namespace {

constexpr Eigen::Index most_shapes = 12;

report::CurvePlot values_plot(const series::Pod& pod) {
  report::CurvePlot plot;
  plot.title = "Proper orthogonal values";
  plot.x = {"mode", false};
  plot.y = {"mean square λ", true};
  report::Series series{"λ", {}, report::Style::line};
  for (Eigen::Index k = 0; k < pod.values.size(); ++k) {
    plot.x_values.push_back(static_cast<double>(k + 1));
    series.y.push_back(pod.values(k) > 0.0 ? pod.values(k) : nan);
  }
  plot.series.push_back(std::move(series));
  return plot;
}

report::CurvePlot shape_plot(const series::Pod& pod, Eigen::Index mode) {
  report::CurvePlot plot;
  plot.title = fmt::format("Mode {}: {:.4f} % of Σσ²", mode + 1, 100.0 * pod.values(mode) / pod.values.sum());
  plot.x = {"channel", false};
  plot.y = {"shape", false};
  plot.level = 0.0;
  report::Series series{fmt::format("mode {}", mode + 1), {}, report::Style::line};
  for (Eigen::Index i = 0; i < pod.modes.rows(); ++i) {
    plot.x_values.push_back(static_cast<double>(i + 1));
    series.y.push_back(pod.modes(i, mode));
  }
  plot.series.push_back(std::move(series));
  return plot;
}

report::PlotGroup shape_plots(const series::Pod& pod) {
  report::PlotGroup group{"mode", {}};
  for (Eigen::Index k = 0; k < std::min(pod.modes.cols(), most_shapes); ++k)
    group.choices.push_back({fmt::format("{}", k + 1), {shape_plot(pod, k)}});
  return group;
}

}  // namespace

std::string pod_report(const PodReport& report) {
  const series::Pod& pod = report.pod;
  report::ReportPage page("Proper orthogonal modes", "jointid pod");
  page.status(report::status_banner(pod_remarks(report).empty() ? "ok" : "doubtful",
                                    fmt::format("{} samples of {} channels; {} modes hold 99 %, {} hold 99.99 % of Σσ².",
                                                pod.samples, report.names.size(), pod.modes_for(0.99), pod.modes_for(0.9999)),
                                    pod_remarks(report)));
  page.section("Values");
  page.add(report::PlotGroup{"", {{"", {values_plot(pod)}}}});
  page.add(values_table(pod));
  page.add(report::Text{
      "Values are mean squares of uncorrelated coordinates: an energy only of velocities with the mass matrix in the inner "
      "product.",
      true});
  page.section("Modes");
  page.add(shape_plots(pod));
  page.add(shapes_table(report));
  if (report.cosines.size() > 0) {
    page.section("Beside " + report.compared);
    page.add(comparison_table(report));
  }
  return page.html();
}

}  // namespace jointid::cli
