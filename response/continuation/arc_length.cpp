#include "response/continuation/arc_length.hpp"

#include <algorithm>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "dense/real_lu.hpp"

namespace jointid::response {
namespace {

constexpr int most_corrections = 12;
constexpr double corrected = 1e-12;  ///< last correction, in the scaled unknowns

/// The equations in scaled unknowns z = (y/size, λ/width).
class Follower {
 public:
  Follower(const CurveEquations& equations, const ArcOptions& options)
      : equations_(equations), width_(std::abs(options.to - options.from)) {}

  /// Sizes follow the amplitude from point to point.
  void rescale(const Eigen::VectorXd& y) { size_ = std::max(y.norm(), 1e-300); }

  /// Unit tangent at a point that goes on along `along` (in the unscaled variables).
  void set_tangent(CurvePoint& point, const Eigen::VectorXd& along, double along_parameter) const {
    const CurveEquations::Value value = equations_.evaluate(point.unknowns, point.parameter);
    const Eigen::Index m = point.unknowns.size();
    Eigen::VectorXd right = Eigen::VectorXd::Zero(m + 1);
    right(m) = 1.0;
    Eigen::VectorXd t = dense::RealLu(bordered(value, along, along_parameter)).solve(right);
    t /= t.norm();
    point.tangent = size_ * t.head(m);
    point.parameter_tangent = width_ * t(m);
  }

  /// The point at arc length s from `from`, by Newton's method orthogonal to its tangent; none when it does not converge.
  std::optional<CurvePoint> correct(const CurvePoint& from, double s) const {
    CurvePoint point = from;
    point.unknowns += s * from.tangent;
    point.parameter += s * from.parameter_tangent;
    double before = std::numeric_limits<double>::infinity();
    for (point.steps = 1; point.steps <= most_corrections; ++point.steps) {
      const CurveEquations::Value value = equations_.evaluate(point.unknowns, point.parameter);
      const Eigen::Index m = point.unknowns.size();
      Eigen::VectorXd right(m + 1);
      right.head(m) = -value.residual / size_;
      right(m) = s - advance(from, point);
      const Eigen::VectorXd step = dense::RealLu(bordered(value, from.tangent, from.parameter_tangent)).solve(right);
      const double change = step.norm();
      if (!std::isfinite(change) || change > 1.0) return std::nullopt;
      point.unknowns += size_ * step.head(m);
      point.parameter += width_ * step(m);
      if (change <= corrected || (change <= 1e-9 && change >= 0.5 * before)) {
        set_tangent(point, from.tangent, from.parameter_tangent);
        return point;
      }
      before = change;
    }
    return std::nullopt;
  }

 private:
  double advance(const CurvePoint& from, const CurvePoint& to) const {
    return from.tangent.dot(to.unknowns - from.unknowns) / (size_ * size_) +
           from.parameter_tangent * (to.parameter - from.parameter) / (width_ * width_);
  }

  Eigen::MatrixXd bordered(const CurveEquations::Value& value, const Eigen::VectorXd& along, double along_parameter) const {
    const Eigen::Index m = value.residual.size();
    Eigen::MatrixXd matrix(m + 1, m + 1);
    matrix.topLeftCorner(m, m) = value.by_unknowns;
    matrix.topRightCorner(m, 1) = value.by_parameter * (width_ / size_);
    matrix.bottomLeftCorner(1, m) = along.transpose() / size_;
    matrix(m, m) = along_parameter / width_;
    return matrix;
  }

  const CurveEquations& equations_;
  double width_, size_ = 1.0;
};

/// The zero of the event between `from` and the point at arc length s of it.
std::optional<CurvePoint> refine(const Follower& follower, const CurvePoint& from, double s, double value_from, double value_to,
                                 const CurveFunction& event) {
  std::optional<CurvePoint> last;
  bool lost = false;
  const auto value = [&](double arc) {
    const auto point = follower.correct(from, arc);
    if (!point) {
      lost = true;
      return 0.0;
    }
    last = point;
    return event(*point);
  };
  std::uintmax_t most = 100;
  const auto close = [](double a, double b) { return std::abs(a - b) <= 1e-14 * std::max(std::abs(a), std::abs(b)); };
  const auto [low, high] = boost::math::tools::toms748_solve(value, 0.0, s, value_from, value_to, close, most);
  if (lost) return std::nullopt;
  return follower.correct(from, 0.5 * (low + high));
}

void find_events(const Follower& follower, const CurvePoint& from, const CurvePoint& to, double s,
                 const std::vector<CurveFunction>& functions, Curve& curve) {
  for (std::size_t i = 0; i < functions.size(); ++i) {
    const double before = functions[i](from), after = functions[i](to);
    if (!((before > 0.0 && after < 0.0) || (before < 0.0 && after > 0.0))) continue;
    if (const auto zero = refine(follower, from, s, before, after, functions[i]))
      curve.events.push_back({*zero, i, before > 0.0});
  }
}

}  // namespace

double parameter_slope(const CurvePoint& point) { return point.parameter_tangent; }

Curve follow(const CurveEquations& equations, const Eigen::VectorXd& start, const ArcOptions& options,
             const std::vector<CurveFunction>& functions) {
  Curve curve;
  Follower follower(equations, options);
  follower.rescale(start);
  CurvePoint now = {.unknowns = start, .parameter = options.from, .tangent = {}, .parameter_tangent = 0.0, .steps = 0};
  const double direction = options.to >= options.from ? 1.0 : -1.0;
  follower.set_tangent(now, Eigen::VectorXd::Zero(start.size()), direction * std::abs(options.to - options.from));
  if (!now.tangent.allFinite()) {
    curve.end = CurveEnd::start_not_converged;
    return curve;
  }
  curve.points.push_back(now);
  double step = options.first_step;
  while (static_cast<int>(curve.points.size()) < options.most_points) {
    follower.rescale(now.unknowns);
    follower.set_tangent(now, now.tangent, now.parameter_tangent);
    const auto next = follower.correct(now, step);
    if (!next) {
      step *= 0.5;
      if (step >= options.shortest_step) continue;
      curve.end = CurveEnd::step_too_short;
      return curve;
    }
    find_events(follower, now, *next, step, functions, curve);
    now = *next;
    curve.points.push_back(now);
    if (direction * (now.parameter - options.to) >= 0.0) return curve;
    if (direction * (now.parameter - options.from) < 0.0) {
      curve.end = CurveEnd::left_backwards;
      return curve;
    }
    step = std::min(options.longest_step, step * std::clamp(static_cast<double>(options.aim) / now.steps, 0.5, 2.0));
  }
  curve.end = CurveEnd::too_many_points;
  return curve;
}

}  // namespace jointid::response
