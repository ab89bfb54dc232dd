#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace jointid::response {

/// m equations R(y, λ) = 0 in m unknowns y and a parameter λ.
struct CurveEquations {
  struct Value {
    Eigen::VectorXd residual;
    Eigen::MatrixXd by_unknowns;
    Eigen::VectorXd by_parameter;
  };
  std::function<Value(const Eigen::VectorXd& y, double parameter)> evaluate;
};

/// A point of the curve and its unit tangent in (y/size, λ/width), in the direction in which it is followed.
struct CurvePoint {
  Eigen::VectorXd unknowns;
  double parameter = 0.0;
  Eigen::VectorXd tangent;         ///< dy/ds
  double parameter_tangent = 0.0;  ///< dλ/ds; it changes its sign at a turning point
  int steps = 0;                   ///< of Newton's method
};

struct ArcOptions {
  double from = 0.0, to = 1.0;  ///< of the parameter; followed from `from` until it leaves the interval
  double first_step = 0.02;     ///< of the arc length, in widths of the interval
  double longest_step = 0.05;
  double shortest_step = 1e-7;
  int aim = 4;  ///< Newton steps a point: fewer lengthen the step, more shorten it
  int most_points = 5000;
};

/// Why a curve ended.
enum class CurveEnd { reached, left_backwards, step_too_short, too_many_points, start_not_converged };

/// A function of a point and its tangent, whose sign changes are looked for along the curve.
using CurveFunction = std::function<double(const CurvePoint&)>;

/// Where a function is 0, refined.
struct CurveEvent {
  CurvePoint point;
  std::size_t function = 0;
  bool falling = false;  ///< from above 0 to below
};

struct Curve {
  std::vector<CurvePoint> points;
  std::vector<CurveEvent> events;
  CurveEnd end = CurveEnd::reached;
};

/// dλ/ds: its zeros are turning points.
double parameter_slope(const CurvePoint& point);

/// Follows the curve from (start, options.from): tangent predictor, Newton corrector orthogonal to it, y in units of its own size
/// and λ of the interval's width, step by the corrector's count. Zeros of `functions` between two points are refined to rounding
/// of the arc.
Curve follow(const CurveEquations& equations, const Eigen::VectorXd& start, const ArcOptions& options,
             const std::vector<CurveFunction>& functions);

}  // namespace jointid::response
