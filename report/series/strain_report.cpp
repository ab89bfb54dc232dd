#include "report/series/strain_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "report/json_value.hpp"
#include "report/page/limits.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"
#include "report/text/notes.hpp"

namespace jointid::report {
namespace {

std::string point_title(double x) { return fmt::format("y({:g}) [m]", x); }

}  // namespace

std::string displacements_title(const tasks::StrainResult& report) {
  std::vector<std::string> row;
  for (const double x : report.task.points) row.push_back(point_title(x));
  return csv_line(row);
}

std::string displacements_csv(const Eigen::MatrixXd& block) {
  std::string text;
  std::vector<std::string> row;
  for (Eigen::Index i = 0; i < block.rows(); ++i) {
    row.clear();
    for (Eigen::Index k = 0; k < block.cols(); ++k) row.push_back(csv_number(block(i, k)));
    text += csv_line(row);
  }
  return text;
}

std::vector<std::string> strain_remarks(const tasks::StrainResult& report) {
  constexpr double bad_condition = 1e3;
  std::vector<std::string> out;
  if (report.task.shapes == report.task.gauges.size())
    out.emplace_back("as many shapes as gauges: nothing shows a gauge with a wrong sign, gain or place");
  if (report.map.condition > bad_condition)
    out.push_back(fmt::format("condition {}: the gauges hardly separate the shapes; spread them, or take fewer shapes",
                              number(report.map.condition)));
  return out;
}

Table strain_table(const tasks::StrainResult& report) {
  Table table({{"x m"}, {"noise, m rms per unit strain rms"}});
  for (std::size_t k = 0; k < report.task.points.size(); ++k)
    table.add({number(report.task.points[k]), number(report.map.noise(at(k)))});
  return table;
}

PlotGroup strain_plots(const tasks::StrainResult& report) {
  const auto [first, rate_hz] = tasks::first_displacements(report, most_points);
  CurvePlot plot;
  plot.title = fmt::format("Displacements, the first {} samples", first.rows());
  plot.x = {rate_hz ? "time (s)" : "sample", false};
  plot.y = {"m", false};
  for (Eigen::Index i = 0; i < first.rows(); ++i) plot.x_values.push_back(static_cast<double>(i) / rate_hz.value_or(1.0));
  for (Eigen::Index k = 0; k < std::min(first.cols(), at(most_frfs)); ++k) {
    const auto y = first.col(k);
    plot.series.push_back(
        {fmt::format("y({:g})", report.task.points[static_cast<std::size_t>(k)]), {y.begin(), y.end()}, Style::line});
  }
  return {"", {{"", {plot}}}};
}

std::string strain_summary(const tasks::StrainResult& report) {
  return fmt::format("{} gauges, {} shapes{}, condition {}", report.task.gauges.size(), report.task.shapes,
                     report.task.static_shapes ? " with those of a tip force and a tip moment" : "",
                     number(report.map.condition));
}

std::string strain_text(const tasks::StrainResult& report) {
  std::string text = strain_summary(report) + "\n";
  text += notes_text(strain_remarks(report));
  return text + strain_table(report).text();
}

std::string strain_json(const tasks::StrainResult& report) {
  const oscillation::StrainMap& map = report.map;
  Json out = {{"status", "ok"},
              {"condition", value(map.condition)},
              {"points", values(report.task.points)},
              {"noise", values(std::vector<double>(map.noise.begin(), map.noise.end()))},
              {"remarks", strain_remarks(report)}};
  for (Eigen::Index k = 0; k < map.matrix.rows(); ++k) {
    const Eigen::VectorXd row = map.matrix.row(k);
    out["matrix"].push_back(values(std::vector<double>(row.begin(), row.end())));
  }
  return json_text(out);
}

std::string strain_page(const tasks::StrainResult& report, const PlotGroup& plots) {
  ReportPage page(report.task.file.string(), "jointid series strain");
  page.status(status_banner("ok", strain_summary(report) + ".", strain_remarks(report)));
  page.section("Points");
  page.add(strain_table(report));
  page.section("Displacements");
  page.add(plots);
  return page.html();
}

}  // namespace jointid::report
