#include "friction/quadrature.hpp"

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

namespace jointid::friction {

double integrate(const std::function<double(double)>& f, std::span<const double> ends) {
  // At most about 1500 points: more cannot help where rounding of f is above the tolerance.
  static thread_local boost::math::quadrature::tanh_sinh<double> rule(8);
  double sum = 0.0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const double from = ends[i - 1], width = ends[i] - from;
    // On [0, 1], where the rule's points near the ends differ from them whatever the width.
    if (width > 0.0) sum += width * rule.integrate([&](double t) { return f(from + width * t); }, 0.0, 1.0, 1e-14);
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
