#include <algorithm>
#include <cmath>

#include "modalfit/model/pole_search.hpp"
#include "modalfit/model/uncertainty.hpp"
#include "modalfit/poles/doubled.hpp"
#include "modalfit/poles/exactness.hpp"

namespace jointid::modalfit {
namespace {

/// As quiet_noise where the mean square of the residuals is far above it, for what a model lacks is part of what is taken for
/// noise.
constexpr double rather_quiet = 1e-2;
constexpr double far_off = 100.0;
constexpr double apart = 6.0;  ///< standard deviations between poles of such FRFs
constexpr std::size_t most_splits_tried = 3;

}  // namespace

/// Noise over modulus below which FRFs may be computed ones.
double PoleSearch::quiet_where(const RefinedPoles& refined) const {
  return refined.cost > far_off * refined.freedom ? rather_quiet : quiet_noise;
}

/// Whether neighbouring lines agree to digits that no measurement has although the model does not.
bool PoleSearch::may_be_exact(const RefinedPoles& refined) const {
  if (band_.known_noise) return false;
  const double noise = relative_noise(band_, entries_);
  const bool is_off = refined.cost > refined.freedom || !is_exact(band_, entries_, options_.kind, refined.poles);
  return noise < quiet_where(refined) && is_off;
}

/// FRFs without noise tell poles apart that noise would not, and poles beyond the range better: what follows them to their
/// digits is taken.
void PoleSearch::seek_exact(RefinedPoles& refined, ModalFit& out) {
  ModalFit other;
  const std::vector<double> weight = band_.weight;
  const double before = deviation(band_, entries_, options_.kind, refined.poles);
  RefinedPoles exact = settled(candidates({.most_damping = options_.most_damping, .apart = apart}, other), false, other);
  extend(exact, other);
  while (!is_exact(band_, entries_, options_.kind, exact.poles) && split(exact, other)) extend(exact, other);
  add_peaks(exact, other);
  const double after = deviation(band_, entries_, options_.kind, exact.poles);
  if (exact.converged && after < nearly_exact && after < 0.5 * before) {
    refined = std::move(exact);
    out = std::move(other);
  } else {
    band_.weight = weight;
  }
}

/// Two poles in place of the one on which the FRFs agree least; false, and all as before, when that does not halve the residuals.
bool PoleSearch::split(RefinedPoles& refined, ModalFit& out) {
  if (!refined.converged || refined.poles.empty() || stopped()) return false;
  const double before = deviation(band_, entries_, options_.kind, refined.poles);
  const std::vector<double> weight = band_.weight;
  for (const std::size_t r : least_agreed(refined)) {
    std::vector<Pole> poles = refined.poles;
    const double apart_hz = 0.5 * half_width_hz(options_.kind, poles[r]);
    poles.push_back({poles[r].frequency_hz + apart_hz, poles[r].damping});
    poles[r].frequency_hz -= apart_hz;
    RefinedPoles two = settled(std::move(poles), true, out);
    if (two.converged && two.poles.size() > refined.poles.size() && deviation(band_, entries_, options_.kind, two.poles) < 0.5 * before) {
      refined = std::move(two);
      return true;
    }
    band_.weight = weight;
  }
  return false;
}

/// The three poles inside of which single FRFs have the most different frequencies, in half widths.
std::vector<std::size_t> PoleSearch::least_agreed(const RefinedPoles& refined) const {
  const PoleScatter scatter = pole_scatter(band_, entries_, options_.kind, refined);
  std::vector<std::pair<double, std::size_t>> spread;
  for (std::size_t r = 0; r < refined.poles.size(); ++r) {
    if (!is_inside(refined.poles[r], band_)) continue;
    spread.emplace_back((scatter.own_hz[r][1] - scatter.own_hz[r][0]) / half_width_hz(options_.kind, refined.poles[r]), r);
  }
  std::ranges::sort(spread, std::greater{});
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < std::min(most_splits_tried, spread.size()); ++i) out.push_back(spread[i].second);
  return out;
}

}  // namespace jointid::modalfit
