#include "report/laws/direct_plots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "base/complex.hpp"
#include "response/fourier/harmonics.hpp"

namespace jointid::report {
namespace {

struct EquivalentPoint {
  double motion = 0.0;
  Complex value, deviation;
};

std::vector<EquivalentPoint> equivalent_points(const std::vector<response::DirectStep>& steps, Eigen::Index joint) {
  std::vector<EquivalentPoint> points;
  for (const response::DirectStep& step : steps) {
    const Eigen::Index first = response::Harmonics(step.harmonics).find(1);
    if (first >= 0)
      points.push_back({std::abs(step.joint_motion(first, joint)), step.equivalent(joint), step.equivalent_deviation(joint)});
  }
  std::ranges::sort(points, {}, &EquivalentPoint::motion);
  return points;
}

CurvePlot equivalent_plot(const std::vector<EquivalentPoint>& points, const std::string& title, const std::string& label,
                          const std::function<double(Complex)>& part) {
  CurvePlot plot;
  plot.title = title;
  plot.x = {"|Q₁| (m)", true};
  plot.y = {label, false};
  Series middle{"without a law", {}, Style::points}, above{"one deviation above", {}, Style::dashed},
      below{"one below", {}, Style::dashed};
  for (const EquivalentPoint& point : points) {
    plot.x_values.push_back(point.motion);
    middle.y.push_back(part(point.value));
    above.y.push_back(part(point.value) + part(point.deviation));
    below.y.push_back(part(point.value) - part(point.deviation));
  }
  plot.series = {middle, above, below};
  return plot;
}

/// The state of a level with the largest motion of a joint.
std::optional<std::size_t> largest_state(const laws::DirectIdentification& found, std::size_t level, Eigen::Index joint) {
  std::optional<std::size_t> best;
  double most = 0.0;
  for (std::size_t i = 0; i < found.steps.size(); ++i) {
    const Eigen::Index first = response::Harmonics(found.steps[i].harmonics).find(1);
    if (found.data.level[i] != level || first < 0) continue;
    const double motion = std::abs(found.steps[i].joint_motion(first, joint));
    if (best && motion <= most) continue;
    best = i;
    most = motion;
  }
  return best;
}

PointGroup loop_of(const response::DirectStep& step, Eigen::Index joint, const std::string& name) {
  constexpr int instants = 96;
  PointGroup group{name, {}};
  for (int t = 0; t < instants; ++t) {
    Point point;
    for (std::size_t n = 0; n < step.harmonics.size(); ++n) {
      const Complex turn = std::polar(1.0, 2.0 * std::numbers::pi * step.harmonics[n] * t / instants);
      point.x += (step.joint_motion(at(n), joint) * turn).real();
      point.y += (step.joint_force(at(n), joint) * turn).real();
    }
    group.points.push_back(std::move(point));
  }
  return group;
}

}  // namespace

PlotGroup equivalent_plots(const laws::LawScene& scene, const laws::DirectIdentification& found) {
  PlotGroup group{"joint", {}};
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const std::vector<EquivalentPoint> points = equivalent_points(found.steps, at(j));
    if (points.empty()) continue;
    group.choices.push_back({scene.joints[j].beside.name,
                             {equivalent_plot(points, "Equivalent stiffness", "k_e (N/m)", [](Complex z) { return z.real(); }),
                              equivalent_plot(points, "Equivalent damping", "d_e (N/m)", [](Complex z) { return z.imag(); })}});
  }
  return group;
}

PlotGroup loop_plots(const laws::LawScene& scene, const laws::DirectIdentification& found) {
  PlotGroup group{"joint", {}};
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    ScatterPlot plot;
    plot.title = "Measured loops";
    plot.x = {"q (m)", false};
    plot.y = {"force (N)", false};
    for (std::size_t level = 0; level < scene.levels.size(); ++level) {
      const auto state = largest_state(found, level, at(j));
      if (!state) continue;
      const std::string name = fmt::format("{}, {:.5g} Hz", scene.levels[level].name, hertz(found.steps[*state].omega));
      plot.groups.push_back(loop_of(found.steps[*state], at(j), name));
    }
    if (!plot.groups.empty()) group.choices.push_back({scene.joints[j].beside.name, {std::move(plot)}});
  }
  return group;
}

}  // namespace jointid::report
