#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "frf/set/h1.hpp"

namespace jointid::records {

/// w_t of N samples: 1, or (1 − cos 2πt/N)/2, periodic as spectra want it (scipy.signal.get_window).
std::vector<double> make_window(frf::Window window, std::size_t samples);

/// The force window of a blow: 1 up to `hold_s` after its peak, from there down by half a cosine within a quarter of that, then
/// 0: the noise of the hammer after the pulse does not count. `peak`: its sample within the stretch.
std::vector<double> force_window(std::size_t samples, std::size_t peak, double hold_s, double rate_hz);

/// e^(−t/τ) of force and motion alike from the beginning of the stretch on: noise after the motion has died away counts less, and
/// the rest of lightly damped modes at the end. It moves all poles to the left by 1/τ; decay_correction.hpp moves the FRFs back.
std::vector<double> exponential_window(std::size_t samples, double decay_time_s, double rate_hz);

}  // namespace jointid::records
