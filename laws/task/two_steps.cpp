#include "laws/task/two_steps.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "friction/fit/fit.hpp"

namespace jointid::laws {
namespace {

friction::Curve equivalents(const std::vector<response::DirectStep>& steps, Eigen::Index joint) {
  struct Point {
    double motion;
    Complex equivalent;
  };
  std::vector<Point> points;
  for (const response::DirectStep& step : steps)
    points.push_back({std::abs(step.joint_motion(0, joint)), step.equivalent(joint)});
  std::ranges::sort(points, {}, &Point::motion);
  friction::Curve curve;
  curve.kind = friction::CurveKind::equivalent;
  for (const Point& point : points) {
    curve.u.push_back(point.motion);
    curve.value.push_back(point.equivalent.real());
    curve.damping.push_back(point.equivalent.imag());
  }
  return curve;
}

}  // namespace

std::vector<TwoSteps> two_steps(const std::vector<response::DirectStep>& steps, const std::vector<std::string>& laws) {
  std::vector<TwoSteps> out(laws.size(), TwoSteps{nan, nan});
  for (std::size_t j = 0; j < laws.size(); ++j) {
    const friction::Curve curve = equivalents(steps, at(j));
    const friction::Fit fit = friction::fit(std::span(&curve, 1), friction::family(laws[j]));
    if (!fit.curves.empty()) out[j] = {fit.curves[0].stiffness.value, fit.curves[0].limit.value};
  }
  return out;
}

}  // namespace jointid::laws
