#include "records/estimate/window.hpp"

#include <cmath>
#include <numbers>

namespace jointid::records {

std::vector<double> make_window(frf::Window window, std::size_t samples) {
  std::vector<double> w(samples, 1.0);
  if (window == frf::Window::rectangular) return w;
  for (std::size_t t = 0; t < samples; ++t) {
    w[t] = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(t) / static_cast<double>(samples));
  }
  return w;
}

std::vector<double> force_window(std::size_t samples, std::size_t peak, double hold_s, double rate_hz) {
  std::vector<double> w(samples, 0.0);
  const double fall_s = 0.25 * hold_s;
  for (std::size_t t = 0; t < samples; ++t) {
    const double after = (static_cast<double>(t) - static_cast<double>(peak)) / rate_hz;
    if (after <= hold_s)
      w[t] = 1.0;
    else if (after < hold_s + fall_s)
      w[t] = 0.5 + 0.5 * std::cos(std::numbers::pi * (after - hold_s) / fall_s);
  }
  return w;
}

std::vector<double> exponential_window(std::size_t samples, double decay_time_s, double rate_hz) {
  std::vector<double> w(samples);
  for (std::size_t t = 0; t < samples; ++t) w[t] = std::exp(-static_cast<double>(t) / (rate_hz * decay_time_s));
  return w;
}

}  // namespace jointid::records
