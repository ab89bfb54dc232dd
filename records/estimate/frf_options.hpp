#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "frf/set/h1.hpp"
#include "records/estimate/blow.hpp"
#include "records/estimate/estimate.hpp"

namespace jointid::records {

/// Of a shaker: segments of one length.
struct SegmentOptions {
  double block_s = 0.0;  ///< > 0
  double overlap = 0.5;  ///< 0 ≤ overlap < 1
  frf::Window window = frf::Window::hann;
};

/// How FRFs are made of records.
struct FrfOptions {
  HammerOptions hammer;
  std::optional<SegmentOptions> segments;  ///< instead of blows
  std::optional<double> force_window_s;    ///< blows: how long after the peak the force counts
  std::optional<double> decay_time_s;      ///< blows: τ of an exponential window, whose damping is taken out again
  bool remove_mean = false;                ///< of every stretch
  Estimator estimator = Estimator::h1;
  NoiseFrom noise = NoiseFrom::residuals;
  std::vector<std::size_t> reject;                         ///< stretches to leave out, by their number from 1
  bool keep_faulty = false;                                ///< average overloaded stretches and double blows too
  double highest_hz = std::numeric_limits<double>::max();  ///< lines above are left out
};

/// Throws InputError (usage) for an option out of its range, and for windows that do not go together.
void validate(const FrfOptions& options);

}  // namespace jointid::records
