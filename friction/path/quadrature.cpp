#include "friction/path/quadrature.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

namespace jointid::friction {

namespace {

/// Over [from, from + width], in halves where the rule itself says that it has not converged: it gives up when a refinement does
/// not help, as in a layer much narrower than the interval. Its estimate is the last change, its error about the square of that.
double integrate(const std::function<double(double)>& f, double from, double width, int depth) {
  // At most about 1500 points: more cannot help where rounding of f is above the tolerance.
  static thread_local boost::math::quadrature::tanh_sinh<double> rule(8);
  double change = 0.0, magnitude = 0.0;
  // On [0, 1], where the rule's points near the ends differ from them whatever the width.
  const double mean = rule.integrate([&](double t) { return f(from + width * t); }, 0.0, 1.0, 1e-14, &change, &magnitude);
  if (change <= 1e-10 * magnitude || depth == 0) return width * mean;
  return integrate(f, from, 0.5 * width, depth - 1) + integrate(f, from + 0.5 * width, 0.5 * width, depth - 1);
}

}  // namespace

double integrate(const std::function<double(double)>& f, std::span<const double> ends) {
  double sum = 0.0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (ends[i] > ends[i - 1]) sum += integrate(f, ends[i - 1], ends[i] - ends[i - 1], 8);
  }
  return sum;
}

double integrate_smooth(const std::function<double(double)>& f, std::span<const double> ends) {
  double sum = 0.0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    sum += boost::math::quadrature::gauss<double, 30>::integrate(f, ends[i - 1], ends[i]);
  }
  return sum;
}

}  // namespace jointid::friction
