#include "response/fourier/periodic_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace jointid::response {
namespace {

using std::numbers::pi;

constexpr double first_sample = 0.1;  ///< so that the extremes of a plain sine or cosine are not at the first sample

/// Walks from reversal to reversal with a stack of open corners.
class Walk {
 public:
  Walk(const friction::Element& element, const Motion& motion, PeriodicPath& path)
      : element_(element), motion_(motion), path_(path) {}

  void begin(double theta) {
    const double q = motion_.value(theta);
    const int direction = q < 0.0 ? -1 : 1;
    open({theta, q, direction * element_.response(std::abs(q)).force, -1, direction});
  }

  /// On to the next reversal, where the path turns.
  void advance(double theta) {
    double from = path_.corners[static_cast<std::size_t>(open_.back())].theta;
    const double q = motion_.value(theta);
    const int direction = q < top().displacement ? -1 : 1;
    while (open_.size() >= 3 && direction * (q - before_top().displacement) > 0.0) {
      const double closing = motion_.crossing(from, theta, before_top().displacement);
      stretch(direction, from, closing);
      open_.resize(open_.size() - 2);
      from = closing;
    }
    stretch(direction, from, theta);
    const double travel = std::max(0.0, 0.5 * direction * (q - top().displacement));
    open({theta, q, top().force + 2.0 * direction * element_.response(travel).force, open_.back(), direction});
  }

 private:
  const PathCorner& top() const { return path_.corners[static_cast<std::size_t>(open_.back())]; }
  const PathCorner& before_top() const { return path_.corners[static_cast<std::size_t>(open_[open_.size() - 2])]; }

  void open(const PathCorner& corner) {
    open_.push_back(static_cast<int>(path_.corners.size()));
    path_.corners.push_back(corner);
  }

  void stretch(int direction, double from, double to) {
    if (to > from) path_.stretches.push_back({open_.back(), direction, from, to});
  }

  const friction::Element& element_;
  const Motion& motion_;
  PeriodicPath& path_;
  std::vector<int> open_;
};

}  // namespace

PeriodicPath periodic_path(const friction::Element& element, const Motion& motion) {
  PeriodicPath path;
  path.half = motion.harmonics().only_odd();
  const double span = path.half ? pi : 2.0 * pi;
  std::vector<double> turns = motion.reversals(first_sample, span);
  path.reversals = static_cast<int>(turns.size()) * (path.half ? 2 : 1);
  if (turns.empty()) return path;

  const auto size = [&](double theta) { return std::abs(motion.value(theta)); };
  const auto largest = std::ranges::max_element(turns, {}, size);
  std::rotate(turns.begin(), largest, turns.end());
  for (double& theta : turns) {
    if (theta < turns.front()) theta += span;
  }
  Walk walk(element, motion, path);
  walk.begin(turns.front());
  for (std::size_t i = 1; i < turns.size(); ++i) walk.advance(turns[i]);
  walk.advance(turns.front() + span);
  return path;
}

}  // namespace jointid::response
