#include "oscillation/measurement/phase.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "base/error.hpp"
#include "base/statistics.hpp"
#include "dense/minimum_norm.hpp"

namespace jointid::oscillation {
namespace {

void check(std::size_t samples, double sample_time, double frequency_hz, std::size_t harmonics) {
  const auto wrong = [](const std::string& problem) {
    throw InputError({ErrorKind::data, "", "record", problem, "record longer or faster"});
  };
  if (!(sample_time > 0.0) || !(frequency_hz > 0.0) || harmonics == 0) wrong("has no sample time, frequency or harmonic above 0");
  if (samples < 2 * harmonics + 1 || static_cast<double>(samples) * sample_time * frequency_hz < 1.0)
    wrong("is shorter than a period");
  if (static_cast<double>(harmonics) * frequency_hz * sample_time >= 0.5)
    wrong("has less than two samples a period of the highest harmonic");
}

}  // namespace

Harmonics fit_harmonics(std::span<const double> x, double sample_time, double frequency_hz, std::size_t harmonics) {
  check(x.size(), sample_time, frequency_hz, harmonics);
  Eigen::MatrixXd basis(at(x.size()), at(2 * harmonics + 1));
  basis.col(0).setOnes();
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double turns = frequency_hz * sample_time * static_cast<double>(i);
    for (std::size_t h = 1; h <= harmonics; ++h) {
      const double angle = 2.0 * std::numbers::pi * std::remainder(static_cast<double>(h) * turns, 1.0);
      basis(at(i), at(2 * h - 1)) = std::cos(angle);
      basis(at(i), at(2 * h)) = std::sin(angle);
    }
  }
  const Eigen::MatrixXd values = Eigen::Map<const Eigen::VectorXd>(x.data(), at(x.size()));
  const Eigen::MatrixXd found = dense::RealMinimumNorm(basis).solve(values);
  Harmonics out;
  out.mean = found(0, 0);
  for (std::size_t h = 1; h <= harmonics; ++h) {
    const double c = found(at(2 * h - 1), 0), s = found(at(2 * h), 0);
    out.amplitude.push_back(std::hypot(c, s));
    out.phase.push_back(std::atan2(s, c));
  }
  out.rest = std::sqrt((values - basis * found).squaredNorm() / static_cast<double>(x.size()));
  return out;
}

double delay_between(const Harmonics& reference, const Harmonics& sensor, double frequency_hz) {
  return std::remainder(sensor.phase[0] - reference.phase[0], 2.0 * std::numbers::pi) / angular(frequency_hz);
}

double sensor_delay(std::span<const double> reference, std::span<const double> sensor, double sample_time, double frequency_hz,
                    std::size_t harmonics) {
  const auto fitted = [&](std::span<const double> x) { return fit_harmonics(x, sample_time, frequency_hz, harmonics); };
  return delay_between(fitted(reference), fitted(sensor), frequency_hz);
}

std::vector<double> advanced(std::span<const double> x, double sample_time, double delay) {
  if (!(sample_time > 0.0) || !std::isfinite(delay))
    throw InputError({ErrorKind::usage, "", "delay", "or sample time is not usable", ""});
  std::vector<double> out(x.size(), nan);
  const double shift = delay / sample_time, whole = std::floor(shift), s = shift - whole;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double first = static_cast<double>(i) + whole;
    if (s == 0.0) {
      if (first >= 0.0 && first < static_cast<double>(x.size())) out[i] = x[static_cast<std::size_t>(first)];
      continue;
    }
    if (first < 1.0 || first + 2.0 >= static_cast<double>(x.size())) continue;
    const auto k = static_cast<std::size_t>(first);
    out[i] = -s * (s - 1.0) * (s - 2.0) / 6.0 * x[k - 1] + (s + 1.0) * (s - 1.0) * (s - 2.0) / 2.0 * x[k] -
             (s + 1.0) * s * (s - 2.0) / 2.0 * x[k + 1] + (s + 1.0) * s * (s - 1.0) / 6.0 * x[k + 2];
  }
  return out;
}

}  // namespace jointid::oscillation
