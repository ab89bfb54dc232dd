#include "tasks/response/clamping_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "friction/path/scaled.hpp"
#include "minimise/least_value.hpp"
#include "tasks/response/level_runs.hpp"
#include "tasks/tell.hpp"

namespace jointid::tasks {
namespace {

constexpr double to_one_per_cent = 0.01;  // of log load
constexpr double a_tenth_more = 1.1;

std::vector<response::Joint> clamped(const ResponseScene& scene, double load) {
  std::vector<response::Joint> joints = joints_of(scene);
  for (const std::size_t j : scene.clamping->joints)
    joints[j].friction = std::make_shared<friction::Scaled>(joints[j].friction, load, load);
  return joints;
}

/// Peaks of one force level, each worked out once.
class ClampedPeaks {
 public:
  ClampedPeaks(const ResponseScene& scene, const Prepared& prepared, const ident::Control& control, double level)
      : scene_(scene), prepared_(prepared), control_(control), level_(level) {}

  /// |X| of the peak at a load; infinite where there is none.
  double operator()(double log_load) {
    const double load = std::exp(log_load);
    tell(control_, fmt::format("{:.6g} N under {:.3g} of the normal load", level_, load));
    stop_if(control_.interrupted);
    const response::HarmonicBalance balance(prepared_.structure, clamped(scene_, load), scene_.force, scene_.harmonics);
    const LevelResponse level = level_response(balance, scene_, prepared_, level_, [&](const auto&) { stop_if(control_.interrupted); });
    ClampedPeak& peak = peaks_.emplace_back();
    peak.load = load;
    peak.complete = is_complete(level);
    if (!level.peak) return std::numeric_limits<double>::infinity();
    peak.amplitude = std::abs(level.peak->response(first_row(*level.peak), 0));
    peak.frequency_hz = hertz(level.peak->omega);
    return *peak.amplitude;
  }

  std::vector<ClampedPeak> sorted() && {
    std::ranges::sort(peaks_, {}, &ClampedPeak::load);
    return std::move(peaks_);
  }

 private:
  const ResponseScene& scene_;
  const Prepared& prepared_;
  const ident::Control& control_;
  double level_;
  std::vector<ClampedPeak> peaks_;
};

/// The load between two peaks at which the amplitude is `size`, along a straight line over log load.
double load_at(double size, const ClampedPeak& inside, const ClampedPeak& outside) {
  const double share = (size - *inside.amplitude) / (*outside.amplitude - *inside.amplitude);
  return inside.load * std::pow(outside.load / inside.load, share);
}

/// From the best on, the first peak that is more than a tenth above it ends the interval.
template <class Iterator>
double end_of_tenth(Iterator best, Iterator last) {
  const double size = a_tenth_more * *best->amplitude;
  auto inside = best;
  for (auto next = best + 1; next != last && next->amplitude; inside = next++) {
    if (*next->amplitude > size) return load_at(size, *inside, *next);
  }
  return inside->load;
}

void find_best(ClampingRun& run) {
  auto best = run.peaks.end();
  for (auto peak = run.peaks.begin(); peak != run.peaks.end(); ++peak) {
    if (peak->amplitude && (best == run.peaks.end() || *peak->amplitude < *best->amplitude)) best = peak;
  }
  if (best == run.peaks.end()) return;
  run.best = *best;
  run.at_end = best == run.peaks.begin() || best + 1 == run.peaks.end();
  run.within_tenth = {end_of_tenth(std::make_reverse_iterator(best + 1), run.peaks.rend()), end_of_tenth(best, run.peaks.end())};
}

}  // namespace

void run_clamping(const ResponseScene& scene, const Prepared& prepared, const ident::Control& control, ResponseResult& run) {
  if (!scene.clamping) return;
  const double low = std::log(scene.clamping->range[0]), high = std::log(scene.clamping->range[1]);
  for (const double level : scene.levels) {
    ClampedPeaks peaks(scene, prepared, control, level);
    (void)least_over(std::ref(peaks), low, high, static_cast<int>(scene.clamping->points) - 1, to_one_per_cent);
    ClampingRun& found = run.clampings.emplace_back();
    found.level = level;
    found.nominal = scene.clamping->nominal;
    found.peaks = std::move(peaks).sorted();
    find_best(found);
  }
}

}  // namespace jointid::tasks
