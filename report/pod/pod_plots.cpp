#include "report/pod/pod_plots.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/statistics.hpp"

namespace jointid::report {
namespace {

constexpr Eigen::Index most_shapes = 12;

CurvePlot pod_values_plot(const oscillation::Pod& pod) {
  CurvePlot plot;
  plot.title = "Proper orthogonal values";
  plot.x = {"mode", false};
  plot.y = {"mean square λ", true};
  Series series{"λ", {}, Style::line};
  for (Eigen::Index k = 0; k < pod.values.size(); ++k) {
    plot.x_values.push_back(static_cast<double>(k + 1));
    series.y.push_back(pod.values(k) > 0.0 ? pod.values(k) : nan);
  }
  plot.series.push_back(std::move(series));
  return plot;
}

CurvePlot pod_shape_plot(const oscillation::Pod& pod, Eigen::Index mode) {
  CurvePlot plot;
  plot.title = fmt::format("Mode {}: {:.4f} % of Σσ²", mode + 1, 100.0 * pod.values(mode) / pod.values.sum());
  plot.x = {"channel", false};
  plot.y = {"shape", false};
  plot.level = 0.0;
  Series series{fmt::format("mode {}", mode + 1), {}, Style::line};
  for (Eigen::Index i = 0; i < pod.modes.rows(); ++i) {
    plot.x_values.push_back(static_cast<double>(i + 1));
    series.y.push_back(pod.modes(i, mode));
  }
  plot.series.push_back(std::move(series));
  return plot;
}

}  // namespace

PlotGroup pod_value_plots(const oscillation::Pod& pod) { return {"", {{"", {pod_values_plot(pod)}}}}; }

PlotGroup pod_shape_plots(const oscillation::Pod& pod) {
  PlotGroup group{"mode", {}};
  for (Eigen::Index k = 0; k < std::min(pod.modes.cols(), most_shapes); ++k)
    group.choices.push_back({fmt::format("{}", k + 1), {pod_shape_plot(pod, k)}});
  return group;
}

}  // namespace jointid::report
