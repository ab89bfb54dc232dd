#include <algorithm>

#include "modalfit/model/noise_laws.hpp"
#include "modalfit/model/pole_search.hpp"
#include "modalfit/poles/exactness.hpp"
#include "modalfit/poles/rational.hpp"

namespace jointid::modalfit {
namespace {

constexpr std::size_t enough_entries = 24;   ///< FRFs without noise need no mean
constexpr double exact_left = 1e-9;          ///< of the moduli
constexpr double needed_by = 2.0;            ///< what a pole in the range leaves without it, over what is left with it
constexpr std::size_t most_rational = 40;    ///< poles

std::vector<std::size_t> some(const std::vector<std::size_t>& entries) {
  const std::size_t step = (entries.size() + enough_entries - 1) / enough_entries;
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < entries.size(); k += step) out.push_back(entries[k]);
  return out;
}

}  // namespace

/// FRFs without noise are rational functions: their poles are known at once, however many lie beyond the range. Taken where they
/// leave less than the search did, and less than any noise.
void PoleSearch::follow_rational(RefinedPoles& refined, ModalFit& out) {
  if (band_.known_noise || stopped()) return;
  const double before = refined.poles.empty() ? 1.0 : deviation(band_, entries_, options_.kind, refined.poles);
  if (!(before > std::max(exact_left, band_.precision))) return;
  std::vector<Pole> poles = rational_poles(band_, entries_, options_.kind);
  if (poles.empty() || poles.size() > most_rational) return;
  const std::vector<std::size_t> few = some(entries_);
  for (std::size_t r = poles.size(); r-- > 0;) {
    if (!is_inside(poles[r], band_)) continue;
    std::vector<Pole> without = poles;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(r));
    const double left = deviation(band_, few, options_.kind, poles);
    if (deviation(band_, few, options_.kind, without) < needed_by * left) poles = std::move(without);
  }
  const std::vector<double> weight = band_.weight;
  estimate_noise(band_, entries_, options_.kind, poles);
  RefinedPoles found = refine(band_, entries_, options_.kind, poles, {}, options_.interrupted);
  out.iterations += found.iterations;
  const double as_found = deviation(band_, entries_, options_.kind, poles), moved = deviation(band_, entries_, options_.kind, found.poles);
  if (!(moved < exact_left))  // what the model cannot follow must not move the poles
    found = refine(band_, entries_, options_.kind, poles, {.most_iterations = 0}, options_.interrupted);
  const double left = moved < exact_left ? moved : as_found;
  if (left < nearly_exact && left < before && std::ranges::any_of(found.poles, [&](const Pole& pole) { return is_inside(pole, band_); })) {
    refined = std::move(found);
    refined.converged = true;
    out.peaks_left_hz.clear();
    out.remarks.clear();
  } else {
    band_.weight = weight;
  }
}

}  // namespace jointid::modalfit
