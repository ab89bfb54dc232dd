#include "frf/set/h1.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace jointid::frf {
namespace {

/// ∫w(t)w(t+s)dt / ∫w²dt for a window of length 1, 0 ≤ s < 1.
double correlation(Window window, double s) {
  if (window == Window::rectangular) return 1.0 - s;
  const double angle = 2.0 * std::numbers::pi * s;
  // w = (1 − cos 2πt)/2: ∫₀^{1−s} w(t)w(t+s) dt, divided by ∫w² = 3/8.
  return ((1.0 - s) * (2.0 + std::cos(angle)) + 3.0 / (2.0 * std::numbers::pi) * std::sin(angle)) / 3.0;
}

}  // namespace

double h1_variance(std::complex<double> frf, double coherence, double averages) {
  return std::norm(frf) * (1.0 - coherence) / (coherence * (averages - 1.0));
}

std::complex<double> h1_part_variances(std::complex<double> frf, double coherence, double averages) {
  const double part = coherence > 0.0 ? 0.5 * h1_variance(frf, std::min(coherence, 1.0), averages)
                                      : std::numeric_limits<double>::quiet_NaN();
  return {part, part};
}

double effective_averages(int averages, double overlap, Window window) {
  const double n = averages, step = 1.0 - overlap;
  double sum = 1.0;
  for (int k = 1; k < averages && k * step < 1.0; ++k) {
    const double rho = correlation(window, k * step);
    sum += 2.0 * (1.0 - k / n) * rho * rho;
  }
  return n / sum;
}

}  // namespace jointid::frf
