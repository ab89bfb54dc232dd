#include "report/series/strain_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/control.hpp"
#include "base/error.hpp"
#include "records/file/open_samples.hpp"
#include "report/json_value.hpp"
#include "report/page/limits.hpp"
#include "report/page/page.hpp"
#include "report/page/status_banner.hpp"

namespace jointid::report {
namespace {

series::StrainMap map_of(const StrainTask& task) {
  if (task.static_shapes && task.shapes < 2)
    throw InputError(
        {ErrorKind::usage, "", "--static-shapes", "are two, and the basis has one shape", "take more gauges, or leave it out"});
  return series::strain_map({task.length, task.thickness, task.gauges}, series::beam_basis(task.shapes, task.static_shapes),
                            task.points);
}

/// Displacements of the next samples, [samples, points]; no rows at the end.
Eigen::MatrixXd next_displacements(records::SampleStream& stream, const series::StrainMap& map, std::size_t samples) {
  RowMatrixXd block(at(samples), map.matrix.cols());
  const std::size_t count = stream.read({block.data(), static_cast<std::size_t>(block.size())});
  return block.topRows(at(count)) * map.matrix.transpose();
}

std::string point_title(double x) { return fmt::format("y({:g}) [m]", x); }

}  // namespace

StrainReport strain_report(const StrainTask& task) {
  StrainReport out;
  out.task = task;
  if (out.task.points.empty()) out.task.points = {task.length};
  if (out.task.shapes == 0) out.task.shapes = task.gauges.size();
  out.map = map_of(out.task);
  return out;
}

std::unique_ptr<records::SampleStream> open_gauges(const StrainTask& task) {
  auto stream = records::open_samples(task.file, {task.channels, 0, 1});
  if (stream->channels().size() != task.gauges.size()) {
    throw InputError({ErrorKind::data, stream->file(), "",
                      fmt::format("has {} channels for {} gauges", stream->channels().size(), task.gauges.size()),
                      "name the channels of the gauges with --channels, in the order of --gauges"});
  }
  return stream;
}

std::size_t write_displacements(const StrainReport& report, records::SampleStream& gauges,
                                const std::function<void(const std::string& text)>& write,
                                const std::function<bool()>& interrupted) {
  constexpr std::size_t block_rows = 4096;
  std::vector<std::string> row;
  for (const double x : report.task.points) row.push_back(point_title(x));
  write(csv_line(row));
  for (std::size_t samples = 0;;) {
    stop_if(interrupted);
    const Eigen::MatrixXd y = next_displacements(gauges, report.map, block_rows);
    if (y.rows() == 0) return samples;
    std::string text;
    for (Eigen::Index i = 0; i < y.rows(); ++i) {
      row.clear();
      for (Eigen::Index k = 0; k < y.cols(); ++k) row.push_back(csv_number(y(i, k)));
      text += csv_line(row);
    }
    write(text);
    samples += static_cast<std::size_t>(y.rows());
  }
}

std::vector<std::string> strain_remarks(const StrainReport& report) {
  constexpr double bad_condition = 1e3;
  std::vector<std::string> out;
  if (report.task.shapes == report.task.gauges.size())
    out.emplace_back("as many shapes as gauges: nothing shows a gauge with a wrong sign, gain or place");
  if (report.map.condition > bad_condition)
    out.push_back(fmt::format("condition {}: the gauges hardly tell the shapes apart; spread them, or take fewer shapes",
                              number(report.map.condition)));
  return out;
}

Table strain_table(const StrainReport& report) {
  Table table({{"x m"}, {"noise, m rms per unit strain rms"}});
  for (std::size_t k = 0; k < report.task.points.size(); ++k)
    table.add({number(report.task.points[k]), number(report.map.noise(at(k)))});
  return table;
}

PlotGroup strain_plots(const StrainReport& report) {
  const auto gauges = open_gauges(report.task);
  const Eigen::MatrixXd first = next_displacements(*gauges, report.map, most_points);
  const std::optional<double> rate_hz = gauges->rate_hz();
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

std::string strain_summary(const StrainReport& report) {
  return fmt::format("{} gauges, {} shapes{}, condition {}", report.task.gauges.size(), report.task.shapes,
                     report.task.static_shapes ? " with those of a tip force and a tip moment" : "",
                     number(report.map.condition));
}

std::string strain_text(const StrainReport& report) {
  std::string text = strain_summary(report) + "\n";
  for (const std::string& remark : strain_remarks(report)) text += "note: " + remark + "\n";
  return text + strain_table(report).text();
}

std::string strain_json(const StrainReport& report) {
  const series::StrainMap& map = report.map;
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

std::string strain_page(const StrainReport& report, const PlotGroup& plots) {
  ReportPage page(report.task.file.string(), "jointid series strain");
  page.status(status_banner("ok", strain_summary(report) + ".", strain_remarks(report)));
  page.section("Points");
  page.add(strain_table(report));
  page.section("Displacements");
  page.add(plots);
  return page.html();
}

}  // namespace jointid::report
