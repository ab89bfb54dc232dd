#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace jointid::oscillation {

/// x ≈ mean + Σ a_h cos(2πh f t − φ_h), t = i·sample_time, by least squares.
struct Harmonics {
  double mean = 0.0;
  std::vector<double> amplitude, phase;  ///< h = 1 …; radians in (−π, π]
  double rest = 0.0;                     ///< rms of what is left
};

/// Throws InputError for a record shorter than a period or fewer than 2·harmonics + 1 samples, or above half the sampling rate.
Harmonics fit_harmonics(std::span<const double> x, double sample_time, double frequency_hz, std::size_t harmonics = 1);

/// How much later the fundamental of `sensor` is than that of `reference`, s, in (−1/2f, 1/2f].
double delay_between(const Harmonics& reference, const Harmonics& sensor, double frequency_hz);

/// How much later than `reference` a sensor shows the same fundamental, s, in (−1/2f, 1/2f]: one phase cannot tell whole periods.
/// Further harmonics are fitted beside it, since they would leak into it from records of no whole number of periods.
double sensor_delay(std::span<const double> reference, std::span<const double> sensor, double sample_time, double frequency_hz,
                    std::size_t harmonics = 3);

/// The record moved to earlier times by `delay`, x(t + delay), by cubic interpolation; samples that would lie outside are NaN. Of
/// a sinusoid with p samples a period the error is about 23 (2/p)⁴ of its amplitude at most: resample records with fewer than 20.
std::vector<double> advanced(std::span<const double> x, double sample_time, double delay);

}  // namespace jointid::oscillation
