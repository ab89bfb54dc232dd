#include "laws/task/direct_bins.hpp"

#include <algorithm>

#include "base/statistics.hpp"
#include "response/fourier/harmonics.hpp"

namespace jointid::laws {

std::vector<DirectBin> direct_bins(const std::vector<response::DirectStep>& steps, Eigen::Index joint, std::size_t most) {
  struct Point {
    double motion;
    Complex equivalent, deviation;
  };
  std::vector<Point> points;
  for (const response::DirectStep& step : steps) {
    const Eigen::Index first = response::Harmonics(step.harmonics).find(1);
    if (first < 0) continue;
    points.push_back({std::abs(step.joint_motion(first, joint)), step.equivalent(joint), step.equivalent_deviation(joint)});
  }
  std::ranges::sort(points, {}, &Point::motion);
  std::vector<DirectBin> bins;
  const std::size_t count = std::min(most, points.size());
  for (std::size_t b = 0; b < count; ++b) {
    const std::size_t from = b * points.size() / count, to = (b + 1) * points.size() / count;
    const auto middle = [&](auto of) {
      std::vector<double> values;
      for (std::size_t i = from; i < to; ++i) values.push_back(of(points[i]));
      return median(std::move(values));
    };
    bins.push_back(
        {middle([](const Point& p) { return p.motion; }),
         {middle([](const Point& p) { return p.equivalent.real(); }), middle([](const Point& p) { return p.equivalent.imag(); })},
         {middle([](const Point& p) { return p.deviation.real(); }), middle([](const Point& p) { return p.deviation.imag(); })},
         to - from});
  }
  return bins;
}

}  // namespace jointid::laws
