#include "report/oscillate/oscillate_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "base/statistics.hpp"
#include "report/decimate.hpp"
#include "report/json_value.hpp"
#include "report/page/contents.hpp"
#include "report/page/limits.hpp"

namespace jointid::report {
namespace {

constexpr std::size_t most_phase_planes = 16;
constexpr Eigen::Index most_mode_shapes = 6;

std::string label(const tasks::SampledColumn& column) {
  return column.unit.empty() ? column.name : column.name + " (" + column.unit + ")";
}

/// Two columns against each other, every so-manieth row.
PointGroup points_of(const std::string& name, const Eigen::Ref<const Eigen::VectorXd>& x,
                     const Eigen::Ref<const Eigen::VectorXd>& y) {
  PointGroup out{name, {}};
  const Eigen::Index step = std::max<Eigen::Index>(1, x.size() / at(most_points));
  for (Eigen::Index i = 0; i < x.size(); i += step) out.points.push_back({x(i), y(i), ""});
  return out;
}

/// A column over time, with its peaks.
CurvePlot over_time(const tasks::SampledMotion& motion, std::size_t column) {
  std::vector<double> time, y;
  for (Eigen::Index i = 0; i < motion.samples.rows(); ++i)
    time.push_back(motion.samples(i, 0)), y.push_back(motion.samples(i, at(column)));
  const std::vector<std::size_t> kept = keep_peaks(std::array{y}, most_points);
  CurvePlot plot;
  plot.title = motion.columns[column].name + " over time";
  plot.x = {"time (s)", false};
  plot.y = {label(motion.columns[column]), false};
  plot.x_values = picked(time, kept);
  plot.series.push_back({motion.columns[column].name, picked(y, kept), Style::line});
  return plot;
}

}  // namespace

PlotGroup phase_plots(const tasks::OscillateResult& run) {
  const tasks::SampledMotion& motion = *run.motion;
  PlotGroup group{"seen at", {}};
  for (std::size_t k = 0; k < std::min(most_phase_planes, motion.seen); ++k) {
    const std::size_t x = 1 + k, v = 1 + motion.seen + k;
    ScatterPlot plot;
    plot.title = "Phase plane of " + motion.columns[x].name;
    plot.x = {label(motion.columns[x]), false};
    plot.y = {label(motion.columns[v]), false};
    plot.groups.push_back(points_of("motion", motion.samples.col(at(x)), motion.samples.col(at(v))));
    ScatterPlot section = plot;
    section.title = std::string("Poincaré section: ") + (run.system.is_driven() ? "once a cycle" : "at break-aways");
    section.groups = {points_of("section", motion.section.col(at(k)), motion.section.col(at(motion.seen + k)))};
    group.choices.push_back({motion.columns[x].name, {plot, section, over_time(motion, x)}});
  }
  return group;
}

PlotGroup contact_plots(const tasks::OscillateResult& run) {
  const tasks::SampledMotion& motion = *run.motion;
  const std::size_t velocity = 1 + 2 * motion.seen, force = velocity + 1;
  ScatterPlot law;
  law.title = "Friction over relative velocity";
  law.x = {label(motion.columns[velocity]), false};
  law.y = {label(motion.columns[force]), false};
  law.groups.push_back(points_of("motion", motion.samples.col(at(velocity)), motion.samples.col(at(force))));
  return {"", {{"", {law, over_time(motion, force)}}}};
}

PlotGroup mode_plots(const tasks::OscillateResult& run) {
  const oscillation::Pod& pod = run.modes->pod;
  const bool beam = run.system.kind == tasks::SystemKind::cantilever;
  CurvePlot plot;
  plot.title = "Proper orthogonal modes";
  plot.x = {beam ? "x (m)" : "coordinate", false};
  plot.y = {"mode", false};
  std::vector<std::size_t> order(run.motion->seen);
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  if (beam) std::ranges::sort(order, {}, [&](std::size_t i) { return run.system.points[i]; });
  for (const std::size_t i : order) plot.x_values.push_back(beam ? run.system.points[i] : static_cast<double>(i + 1));
  for (Eigen::Index k = 0; k < std::min(pod.modes.cols(), most_mode_shapes); ++k) {
    Series series{fmt::format("{}: {:.3f} %", k + 1, 100.0 * pod.values(k) / pod.values.sum()), {}, Style::line};
    for (const std::size_t i : order) series.y.push_back(pod.modes(at(i), k));
    plot.series.push_back(std::move(series));
  }
  return {"", {{"", {plot}}}};
}

PlotGroup sweep_plot(const tasks::OscillateResult& run) {
  constexpr std::size_t most_values = 20'000;
  std::size_t values = 0;
  for (const oscillation::SweepPoint& point : run.sweep) values += point.values.size();
  const std::size_t step = std::max<std::size_t>(1, values / most_values);
  const std::string unit = tasks::swept_unit(run.swept->parameter);
  ScatterPlot plot;
  plot.title = "Bifurcation diagram";
  plot.x = {run.swept->parameter + (unit.empty() ? "" : " (" + unit + ")"), false};
  plot.y = {label(run.motion->columns[1]) + (run.system.is_driven() ? ", once a cycle" : " at break-aways"), false};
  PointGroup group{run.motion->columns[1].name, {}};
  for (const oscillation::SweepPoint& point : run.sweep) {
    for (std::size_t k = 0; k < point.values.size(); k += step) group.points.push_back({point.parameter, point.values[k], ""});
  }
  plot.groups.push_back(std::move(group));
  return {"", {{"", {plot}}}};
}

PlotGroup reduction_plots(const tasks::ReductionTable& reduction) {
  std::set<std::size_t> orders;
  std::map<tasks::BasisKind, std::map<std::size_t, const tasks::ReducedRow*>> rows;
  for (const tasks::ReducedRow& row : reduction.rows) orders.insert(row.order), rows[row.basis][row.order] = &row;
  const auto plot = [&](const std::string& title, const std::string& unit, auto value) {
    CurvePlot out;
    out.title = title;
    out.x = {"coordinates", false};
    out.y = {unit, true};
    out.x_values.assign(orders.begin(), orders.end());
    for (const auto& [kind, by_order] : rows) {
      Series series{word(kind), {}, Style::line};
      for (const std::size_t order : orders) {
        const double y = by_order.contains(order) ? value(by_order.at(order)->error) : nan;
        series.y.push_back(y > 0.0 ? y : nan);
      }
      out.series.push_back(std::move(series));
    }
    return out;
  };
  const bool strain = reduction.judged.unit == "m/m";
  return {"",
          {{"",
            {plot("Error of the motion", "ΔX (%)", [](const auto& error) { return 100.0 * error.motion; }),
             plot("Error of the energy", "ΔE (%)", [](const auto& error) { return 100.0 * error.energy; }),
             plot("Largest error of " + reduction.judged.name, strain ? "µε" : "m",
                  [strain](const auto& error) { return (strain ? 1e6 : 1.0) * error.observed(0); })}}}};
}

}  // namespace jointid::report
