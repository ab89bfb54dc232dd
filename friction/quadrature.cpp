#include "friction/quadrature.hpp"

#include <boost/math/quadrature/tanh_sinh.hpp>

namespace jointid::friction {

double integrate(const std::function<double(double)>& f, std::span<const double> ends) {
  static thread_local boost::math::quadrature::tanh_sinh<double> rule;
  double sum = 0.0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (ends[i] > ends[i - 1]) sum += rule.integrate(f, ends[i - 1], ends[i], 1e-14);
  }
  return sum;
}

}  // namespace jointid::friction
