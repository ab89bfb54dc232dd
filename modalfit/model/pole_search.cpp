#include "modalfit/model/pole_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "modalfit/model/noise_laws.hpp"
#include "modalfit/model/objections.hpp"
#include "modalfit/poles/doubled.hpp"
#include "modalfit/poles/exactness.hpp"
#include "modalfit/poles/residual_peaks.hpp"
#include "modalfit/poles/selection.hpp"

namespace jointid::modalfit {
namespace {

constexpr int most_rounds = 10;
constexpr double most_noise_change = 0.05;  ///< of the variances from round to round, where they are estimated
constexpr int most_peak_rounds = 6;
constexpr std::size_t most_peaks_at_once = 6;
constexpr double least_peak_share = 0.02;  ///< of the highest peak, for one to become a pole in the same round
constexpr int most_merges = 12, most_vague_rounds = 3;
/// A pole beyond the range that wanders longer has no place of its own.
constexpr std::size_t most_trial_iterations = 12;

/// How far beyond the ends of the range a mode can be told from a residual term.
bool is_near(const Pole& pole, const Band& band) {
  return pole.frequency_hz >= 0.5 * band.frequency_hz.front() && pole.frequency_hz <= 2.0 * band.frequency_hz.back();
}

bool has_pole_at(const std::vector<Pole>& poles, const ModelKind& kind, const Pole& peak) {
  return std::ranges::any_of(poles, [&](const Pole& pole) {
    return std::abs(pole.frequency_hz - peak.frequency_hz) < 3.0 * (half_width_hz(kind, peak) + half_width_hz(kind, pole));
  });
}

}  // namespace

RefinedPoles PoleSearch::run(ModalFit& out) {
  RefinedPoles refined = run_usual(out);
  if (!stopped() && may_be_exact(refined)) seek_exact(refined, out);
  follow_rational(refined, out);
  if (!stopped() && leaves_more_than_rounding(refined)) follow_beyond(refined, out);
  return refined;
}

RefinedPoles PoleSearch::run_usual(ModalFit& out) {
  std::vector<Pole> poles = candidates({.most_damping = options_.most_damping}, out);
  tell("refining poles");
  RefinedPoles refined = settled(std::move(poles), false, out);
  add_peaks(refined, out);
  merge_doubled(refined, out);
  extend(refined, out);
  drop_vague(refined, out);
  return refined;
}

std::vector<Pole> PoleSearch::candidates(const ClusterOptions& clusters, ModalFit& out) {
  std::vector<Pole> poles;
  for (int pass = 0; pass < (band_.known_noise ? 1 : 2); ++pass) {
    tell("polyreference fit");
    out.stabilisation = polyreference_poles(band_, options_.polyreference);
    poles.clear();
    for (const Cluster& each : cluster(out.stabilisation, clusters)) {
      poles.push_back({each.pole.frequency_hz, each.pole.damping * damping_per_zeta(options_.kind)});
    }
    if (!band_.known_noise) estimate_noise(band_, entries_, options_.kind, poles);
  }
  return poles;
}

/// Refines poles that were chosen elsewhere, none of which goes.
RefinedPoles PoleSearch::as_given(std::vector<Pole> poles, ModalFit& out) {
  tell("refining poles");
  RefinedPoles refined;
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < most_rounds; ++round) {
    if (!band_.known_noise) estimate_noise(band_, entries_, options_.kind, poles);
    refined = refine(band_, entries_, options_.kind, poles, {}, options_.interrupted);
    out.iterations += refined.iterations;
    poles = refined.poles;
    if (noise_agrees(refined, before) || stopped()) break;
    before = refined.cost;
  }
  out.remarks.push_back(fmt::format("The {} poles were given: none was sought beside them, none left out.", poles.size()));
  return refined;
}

/// Selects and refines until both agree.
RefinedPoles PoleSearch::settled(std::vector<Pole> poles, bool beyond, ModalFit& out) {
  RefinedPoles refined;
  double before = std::numeric_limits<double>::infinity();
  for (int round = 0; round < most_rounds; ++round) {
    poles = select(poles, beyond);
    refined = refine(band_, entries_, options_.kind, poles, {}, options_.interrupted);
    out.iterations += refined.iterations;
    if (!band_.known_noise) estimate_noise(band_, entries_, options_.kind, refined.poles);
    poles = select(refined.poles, beyond);
    if ((poles.size() == refined.poles.size() && round > 0 && noise_agrees(refined, before)) || stopped()) break;
    before = refined.cost;
  }
  return refined;
}

/// Whether the weights of the refinement were those of the noise that it leaves, or no longer change.
bool PoleSearch::noise_agrees(const RefinedPoles& refined, double before) const {
  return band_.known_noise || !(std::abs(refined.cost - refined.freedom) > most_noise_change * refined.freedom) ||
         std::abs(refined.cost - before) <= most_noise_change * before;
}

/// Peaks of the residual FRFs become poles until none stands out. What a pole at the highest of them does not take is said.
void PoleSearch::add_peaks(RefinedPoles& refined, ModalFit& out) {
  std::vector<ResidualPeak> peaks;
  for (int round = 0; round < most_peak_rounds && !stopped(); ++round) {
    tell("peaks of the residual FRFs");
    peaks = residual_peaks(band_, entries_, options_.kind, refined.poles);
    if (peaks.empty()) return;
    const std::size_t known = refined.poles.size();
    std::vector<Pole> poles = refined.poles;
    for (std::size_t i = 0; i < std::min(peaks.size(), most_peaks_at_once); ++i) {
      if (peaks[i].growth >= least_peak_share * peaks.front().growth) poles.push_back(peaks[i].pole);
    }
    const std::vector<Pole> added(poles.begin() + static_cast<std::ptrdiff_t>(known), poles.end());
    RefinedPoles more = settled(std::move(poles), false, out);
    if (std::ranges::none_of(added, [&](const Pole& peak) { return has_pole_at(more.poles, options_.kind, peak); })) {
      if (!band_.known_noise) estimate_noise(band_, entries_, options_.kind, refined.poles);
      break;
    }
    refined = std::move(more);
  }
  for (const ResidualPeak& peak : peaks) {
    if (has_pole_at(refined.poles, options_.kind, peak.pole)) continue;
    out.peaks_left_hz.push_back(peak.pole.frequency_hz);
  }
}

/// Two poles within a half-power bandwidth become one where one does.
void PoleSearch::merge_doubled(RefinedPoles& refined, ModalFit& out) {
  std::vector<std::array<Pole, 2>> kept;
  for (int merge = 0; merge < most_merges && !stopped(); ++merge) {
    const auto pair = doubled_pair(refined.poles, options_.kind, kept);
    if (!pair) return;
    const std::array<Pole, 2> two = {refined.poles[(*pair)[0]], refined.poles[(*pair)[1]]};
    const RefinedPoles before = refine(band_, entries_, options_.kind, refined.poles, {}, options_.interrupted);
    RefinedPoles one = refine(band_, entries_, options_.kind, with_one(refined.poles, *pair), {}, options_.interrupted);
    out.iterations += before.iterations + one.iterations;
    if (!one_pole_does(band_, entries_, options_.kind, one, before, *pair)) {
      kept.push_back(two);
      continue;
    }
    refined = settled(std::move(one.poles), false, out);
    const auto [low, high] = std::minmax(two[0].frequency_hz, two[1].frequency_hz);
    out.remarks.push_back(fmt::format("Poles at {:.6g} and {:.6g} Hz lay within one half-power bandwidth and were merged: one mode{} "
                                      "does for them.",
                                      low, high, entries_.size() > 1 ? ", with a frequency of its own in each FRF," : ""));
  }
}

/// Poles in the range that are no modes go, and their share to the residual terms.
void PoleSearch::drop_vague(RefinedPoles& refined, ModalFit& out) {
  if (is_exact(band_, entries_, options_.kind, refined.poles)) return;  // none is left over
  for (int round = 0; round < most_vague_rounds && refined.converged && !refined.poles.empty() && !stopped(); ++round) {
    const std::vector<std::string> why = objections(band_, entries_, options_, refined);
    if (options_.modes && std::ranges::none_of(why, &std::string::empty)) return;  // what was asked for, rather than nothing
    std::vector<Pole> poles;
    for (std::size_t r = 0; r < why.size(); ++r) {
      if (why[r].empty()) {
        poles.push_back(refined.poles[r]);
      } else {
        out.remarks.push_back(fmt::format("A pole at {:.6g} Hz is no mode and was left out: {}.", refined.poles[r].frequency_hz, why[r]));
      }
    }
    if (poles.size() == refined.poles.size()) return;
    refined = settled(std::move(poles), true, out);
  }
}

/// What is where modes are wanted, and significant.
std::vector<Pole> PoleSearch::select(std::vector<Pole> poles, bool beyond) const {
  const double most = options_.most_damping * damping_per_zeta(options_.kind);
  std::erase_if(poles, [&](const Pole& pole) {
    return pole.damping > most || !(is_inside(pole, band_) || (beyond && is_near(pole, band_)));
  });
  std::optional<std::size_t> count = options_.modes;
  if (count) *count += static_cast<std::size_t>(std::ranges::count_if(poles, [&](const Pole& pole) { return !is_inside(pole, band_); }));
  return significant_poles(band_, entries_, options_.kind, std::move(poles), count);
}

/// Tries a pole beyond each end of the range, and keeps what is significant, provided that the modes inside stay.
void PoleSearch::extend(RefinedPoles& refined, ModalFit& out) {
  if (refined.poles.empty() || !refined.converged || stopped()) return;
  const double low = band_.frequency_hz.front(), high = band_.frequency_hz.back();
  std::vector<double> damping;
  for (const Pole& pole : refined.poles) damping.push_back(pole.damping);
  std::ranges::nth_element(damping, damping.begin() + static_cast<std::ptrdiff_t>(damping.size() / 2));
  const double typical = damping[damping.size() / 2];
  const std::array<double, 2> starts = {high + 0.15 * (high - low), low - 0.15 * std::min(high - low, low)};
  std::array<bool, 2> found{};
  bool more = true;
  while (more) {  // one end may show only when the other is taken care of
    more = false;
    for (std::size_t end = 0; end < 2; ++end) {
      if (found[end] || !add({starts[end], typical}, refined, out)) continue;
      found[end] = more = true;
    }
  }
}

/// Refines with one more pole; false, and all as before, when it is not significant, drives others out or does not settle.
bool PoleSearch::add(const Pole& pole, RefinedPoles& refined, ModalFit& out) {
  std::vector<Pole> poles = refined.poles;
  poles.push_back(pole);
  if (select(poles, true).size() < poles.size()) return false;  // even a misplaced flank is better than none where there is one
  const RefinedPoles first = refine(band_, entries_, options_.kind, std::move(poles),
                                    {.most_iterations = most_trial_iterations}, options_.interrupted);
  out.iterations += first.iterations;
  if (!first.converged || inside(first) != inside(refined)) return false;
  RefinedPoles more = settled(first.poles, true, out);
  if (more.converged && inside(more) == inside(refined) && more.poles.size() > refined.poles.size()) {
    refined = std::move(more);
    return true;
  }
  if (!band_.known_noise) estimate_noise(band_, entries_, options_.kind, refined.poles);
  return false;
}

std::size_t PoleSearch::inside(const RefinedPoles& refined) const {
  return static_cast<std::size_t>(std::ranges::count_if(refined.poles, [&](const Pole& pole) { return is_inside(pole, band_); }));
}

}  // namespace jointid::modalfit
