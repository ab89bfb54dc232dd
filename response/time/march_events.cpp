#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <functional>
#include <optional>

#include "response/time/exact_march.hpp"

namespace jointid::response {
namespace {

using Function = std::function<double(double)>;

/// A root of g between a, g(a) > 0, and b, g(b) < 0, to rounding; where a motion runs away, so that it has no such signs, an end.
double root(const Function& g, double a, double b) {
  const double at_a = g(a), at_b = g(b);
  if (!(at_a > 0.0)) return a;
  if (!(at_b < 0.0)) return b;
  std::uintmax_t iterations = 100;
  const auto found =
      boost::math::tools::toms748_solve(g, a, b, at_a, at_b, boost::math::tools::eps_tolerance<double>(52), iterations);
  return 0.5 * (found.first + found.second);
}

/// Where g, which is not negative at first, becomes negative before b, g(b) < 0. A g that begins at 0 up to rounding is
/// positive a moment later, or else negative from the beginning.
double first_negative(const Function& g, double b) {
  double a = 0.0;
  if (!(g(0.0) > 0.0)) {
    for (a = 0.5 * b; a > 1e-12 * b && !(g(a) > 0.0);) a *= 0.5;
    if (!(g(a) > 0.0)) return 0.0;
  }
  return root(g, a, b);
}

/// Where a function is negative inside [0, h] although it is not at h: at its minimum, the zero of its derivative that rises.
std::optional<double> dip(const Function& g, const Function& falling, double h) {
  if (!(falling(0.0) > 0.0) || !(falling(h) < 0.0)) return {};
  const double lowest = root(falling, 0.0, h);
  if (g(lowest) < 0.0) return lowest;
  return {};
}

/// Where q̇ = 0 up to rounding, a joint that is just about to turn has turned.
struct Course {
  JointCourse& course;
  Eigen::Index joint;

  double q(double tau) const {
    if (course.length() != tau) course.solve(tau);
    return course.q()[joint];
  }
  double velocity(double tau) const {
    if (course.length() != tau) course.solve(tau);
    return course.velocity()[joint];
  }
  double acceleration(double tau) const {
    if (course.length() != tau) course.solve(tau);
    return course.acceleration()[joint];
  }
};

std::optional<double> first_turn(const Course& c, int direction, double h) {
  const Function g = [&](double tau) { return direction * c.velocity(tau); };
  const Function falling = [&](double tau) { return -direction * c.acceleration(tau); };
  if (g(h) < 0.0) return first_negative(g, h);
  if (const auto lowest = dip(g, falling, h)) return first_negative(g, *lowest);
  return {};
}

/// `side` +1: the upper bound, −1: the lower one.
std::optional<double> first_arrival(const Course& c, int side, double bound, double slack, double h) {
  if (!std::isfinite(bound)) return {};
  const Function g = [&](double tau) { return side * (bound - c.q(tau)); };
  const Function nearing = [&](double tau) { return side * c.velocity(tau); };
  if (g(h) < -slack) return first_negative(g, h);
  if (!(nearing(0.0) > 0.0) || !(nearing(h) < 0.0)) return {};
  const double nearest = root(nearing, 0.0, h);
  if (g(nearest) < -slack) return first_negative(g, nearest);
  return {};
}

}  // namespace

/// The course is solved up to h.
ExactMarch::Event ExactMarch::first_event(JointCourse& course, double h) const {
  Event first{.joint = -1, .turns = false, .at = h};
  for (std::size_t j = 0; j < states_.size(); ++j) {
    const Piece& piece = states_[j]->piece();
    const Course joint{course, at(j)};
    const auto earlier = [&](const std::optional<double>& found, bool turns) {
      if (found && (first.joint < 0 || *found < first.at)) first = {at(j), turns, *found};
    };
    const double width = piece.upper - piece.lower, slack = std::isfinite(width) ? 1e-13 * width : 0.0;
    if (piece.direction >= 0) earlier(first_arrival(joint, 1, piece.upper, slack, first.at), false);
    if (piece.direction <= 0) earlier(first_arrival(joint, -1, piece.lower, slack, first.at), false);
    if (piece.direction != 0) earlier(first_turn(joint, piece.direction, first.at), true);
  }
  return first;
}

}  // namespace jointid::response
