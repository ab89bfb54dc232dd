#include "report/laws/law_plots.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/statistics.hpp"
#include "friction/curve/equivalent.hpp"
#include "response/fourier/harmonics.hpp"

namespace jointid::report {
namespace {

/// One state of one joint; values by the law are NaN where none was found.
struct JointPoint {
  double motion = 0.0;
  Complex measured, by_law{nan, nan};
  double residual = nan;  ///< rms in standard deviations
};

double rms_residual(const laws::LawIdentification& found, std::size_t state) {
  if (state >= found.fit().states.size()) return nan;
  const response::MeasuredState& measured = found.data.states[state];
  const Eigen::VectorXd residual = response::in_deviations(measured, found.fit().states[state].response - measured.response);
  return std::sqrt(residual.squaredNorm() / static_cast<double>(residual.size()));
}

Complex by_law(const laws::LawIdentification& found, std::size_t joint, double motion, double omega) {
  if (joint >= found.fit().joints.size()) return {nan, nan};
  const response::Joint& fitted = found.fit().joints[joint].joint;
  if (!fitted.friction) return {nan, nan};
  const friction::Equivalent friction = friction::equivalent(*fitted.friction, motion);
  return {friction.stiffness + fitted.stiffness + 0.75 * fitted.cubic * motion * motion,
          friction.damping + omega * fitted.damping};
}

std::vector<JointPoint> points_of(const laws::LawIdentification& found, std::size_t joint) {
  std::vector<JointPoint> points;
  for (std::size_t i = 0; i < found.steps.size(); ++i) {
    const response::DirectStep& step = found.steps[i];
    const Eigen::Index first = response::Harmonics(step.harmonics).find(1);
    if (first < 0) continue;
    const double motion = std::abs(step.joint_motion(first, at(joint)));
    points.push_back({motion, step.equivalent(at(joint)), by_law(found, joint, motion, step.omega), rms_residual(found, i)});
  }
  std::ranges::sort(points, {}, &JointPoint::motion);
  return points;
}

CurvePlot over_motion(const std::vector<JointPoint>& points, const std::string& title, const std::string& unit) {
  CurvePlot plot;
  plot.title = title;
  plot.x = {"|Q₁| (m)", true};
  plot.y = {unit, false};
  for (const JointPoint& point : points) plot.x_values.push_back(point.motion);
  return plot;
}

void add_series(const std::vector<JointPoint>& points, const std::string& name, Style style,
                const std::function<double(const JointPoint&)>& value, CurvePlot& plot) {
  std::vector<double> y;
  for (const JointPoint& point : points) y.push_back(value(point));
  plot.series.push_back({name, std::move(y), style});
}

}  // namespace

PlotGroup law_plots(const laws::LawScene& scene, const laws::LawIdentification& found) {
  PlotGroup group{"joint", {}};
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const std::vector<JointPoint> points = points_of(found, j);
    if (points.empty()) continue;
    CurvePlot stiffness = over_motion(points, "Equivalent stiffness", "k_e (N/m)");
    CurvePlot damping = over_motion(points, "Equivalent damping", "d_e (N/m)");
    CurvePlot residuals = over_motion(points, "Residuals of the fit", "rms (σ)");
    const std::string law = found.laws()[j];
    add_series(
        points, "without a law", Style::reference_points, [](const JointPoint& p) { return p.measured.real(); }, stiffness);
    add_series(
        points, law, Style::line, [](const JointPoint& p) { return p.by_law.real(); }, stiffness);
    add_series(
        points, "without a law", Style::reference_points, [](const JointPoint& p) { return p.measured.imag(); }, damping);
    add_series(
        points, law, Style::line, [](const JointPoint& p) { return p.by_law.imag(); }, damping);
    add_series(
        points, law, Style::points, [](const JointPoint& p) { return p.residual; }, residuals);
    residuals.level = 1.0;
    group.choices.push_back({scene.joints[j].beside.name, {stiffness, damping, residuals}});
  }
  return group;
}

}  // namespace jointid::report
