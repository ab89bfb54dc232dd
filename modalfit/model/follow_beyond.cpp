#include <algorithm>
#include <array>
#include <cmath>

#include "modalfit/model/noise_laws.hpp"
#include "modalfit/model/pole_search.hpp"
#include "modalfit/poles/exactness.hpp"

namespace jointid::modalfit {
namespace {

constexpr std::size_t most_beyond = 12;                       ///< poles that may be added, one after the other
constexpr std::size_t enough_entries = 24;                    ///< FRFs without noise need no mean
constexpr double most_operations = 3e10;                      ///< of all trials together, some 20 s
constexpr double rounding_left = 1e-11;                       ///< of the moduli: nothing is left to follow
constexpr double hardly_left = 1e-10;                         ///< is not sought after
constexpr double exact_left = 1e-9;                           ///< no step may lower what rounding leaves, and none is needed
constexpr double surely_worth = 0.01;                         ///< of the misfit: no other start is tried
constexpr double worth_a_pole = 0.8;                          ///< of the misfit that a pole leaves: the next may leave nothing
constexpr double worth_all = 0.5;                             ///< of that which all leave
constexpr std::array<double, 3> distances = {0.2, 0.6, 2.0};  ///< beyond an end, of the range or its end

std::vector<std::size_t> thinned(const std::vector<std::size_t>& entries) {
  const std::size_t step = (entries.size() + enough_entries - 1) / enough_entries;
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < entries.size(); k += step) out.push_back(entries[k]);
  return out;
}

/// Multiplications of one iteration of refine(), about.
double operations(const Band& band, std::size_t entries, std::size_t poles) {
  return 2.0 * static_cast<double>(entries * 2 * band.lines()) * std::pow(4.0 + 4.0 * static_cast<double>(poles), 2.0);
}

double middle_damping(const std::vector<Pole>& poles) {
  std::vector<double> damping;
  for (const Pole& pole : poles) damping.push_back(pole.damping);
  std::ranges::nth_element(damping, damping.begin() + static_cast<std::ptrdiff_t>(damping.size() / 2));
  return damping[damping.size() / 2];
}

/// Where poles beyond the outermost ones may be.
std::vector<double> starts_beyond(const Band& band, const std::vector<Pole>& poles) {
  double low = band.frequency_hz.front(), high = band.frequency_hz.back();
  const double width = high - low;
  for (const Pole& pole : poles) low = std::min(low, pole.frequency_hz), high = std::max(high, pole.frequency_hz);
  std::vector<double> starts;
  for (const double distance : distances) {
    starts.push_back(high + distance * width);
    starts.push_back(low / (1.0 + distance));
  }
  return starts;
}

}  // namespace

/// Whether lines agree with their neighbours to digits that no measurement has, and the model leaves more than that.
bool PoleSearch::leaves_more_than_rounding(const RefinedPoles& refined) const {
  if (band_.known_noise || refined.poles.empty()) return false;
  const double left = deviation(band_, entries_, options_.kind, refined.poles);
  return left > std::max(hardly_left, band_.precision) && relative_noise(band_, entries_) < quiet_where(refined);
}

/// Poles beyond the range until the FRFs are followed to their rounding or no pole lowers what is left by a fifth: what far modes
/// do in the range is more than two residual terms can follow.
void PoleSearch::follow_beyond(RefinedPoles& refined, ModalFit& out) {
  const std::vector<std::size_t> few = thinned(entries_);
  const std::size_t modes = inside(refined);
  const double all_before = deviation(band_, entries_, options_.kind, refined.poles);
  const std::vector<double> weight = band_.weight;
  const bool is_quiet = relative_noise(band_, entries_) < quiet_noise;
  RefinedPoles best = refined;
  double left = deviation(band_, few, options_.kind, refined.poles);
  double spent = 0.0;
  for (std::size_t round = 0; round < most_beyond && left > rounding_left && !stopped(); ++round) {
    RefinedPoles next;
    double next_left = worth_a_pole * left;
    for (const double start : starts_beyond(band_, best.poles)) {
      if (spent > most_operations) break;
      std::vector<Pole> poles = best.poles;
      poles.push_back({start, middle_damping(refined.poles)});
      RefinedPoles trial = refine(band_, few, options_.kind, std::move(poles), {}, options_.interrupted);
      out.iterations += trial.iterations;
      spent += static_cast<double>(trial.iterations) * operations(band_, few.size(), trial.poles.size());
      const double trial_left = deviation(band_, few, options_.kind, trial.poles);
      if (inside(trial) != modes || !(trial_left < next_left)) continue;
      next = std::move(trial), next_left = trial_left;
      if (next_left < std::max(rounding_left, surely_worth * left)) break;
    }
    if (next.poles.empty()) break;
    best = std::move(next), left = next_left;
    estimate_noise(band_, few, options_.kind, best.poles);
  }
  if (best.poles.size() == refined.poles.size()) return;
  estimate_noise(band_, entries_, options_.kind, best.poles);
  RefinedPoles whole = refine(band_, entries_, options_.kind, best.poles, {}, options_.interrupted);
  out.iterations += whole.iterations;
  const double all_left = deviation(band_, entries_, options_.kind, whole.poles);
  const bool is_followed = all_left < exact_left;
  if (inside(whole) == modes && (is_followed || (is_quiet && whole.converged && all_left < worth_all * all_before))) {
    refined = std::move(whole);
    refined.converged = true;
  } else {
    band_.weight = weight;
  }
}

}  // namespace jointid::modalfit
