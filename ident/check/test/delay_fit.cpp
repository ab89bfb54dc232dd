#include "ident/check/test/delay_fit.hpp"

#include <cmath>

namespace jointid::ident {
namespace {

constexpr double longest = 2e-4;  ///< s
constexpr int delays = 400;
constexpr int newton_steps = 5;

}  // namespace

DelayFit fit_delay(const std::vector<PhaseSample>& samples) {
  DelayFit best;
  double largest = -1.0;
  for (int i = -delays; i <= delays; ++i) {
    const double delay = longest * i / delays;
    double sum = 0.0;
    for (const PhaseSample& s : samples) sum += (s.value * std::polar(1.0, s.omega * delay)).real();
    if (sum > largest) {
      largest = sum;
      best.delay = delay;
    }
  }
  double slope = 0.0, curvature = 0.0, scatter = 0.0;
  for (int step = 0; step <= newton_steps; ++step) {
    slope = curvature = scatter = 0.0;
    for (const PhaseSample& s : samples) {
      const double imaginary = (s.value * std::polar(1.0, s.omega * best.delay)).imag() * s.omega;
      slope += imaginary;
      scatter += imaginary * imaginary;
      curvature += std::abs(s.value) * s.omega * s.omega;
    }
    if (!(curvature > 0.0)) return best;
    if (step < newton_steps) best.delay -= slope / curvature;
  }
  best.deviation = std::sqrt(scatter) / curvature;
  return best;
}

}  // namespace jointid::ident
