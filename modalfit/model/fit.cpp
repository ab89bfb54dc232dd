#include "modalfit/model/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "modalfit/band/inputs.hpp"
#include "modalfit/model/noise_laws.hpp"
#include "modalfit/model/uncertainty.hpp"
#include "modalfit/poles/clusters.hpp"
#include "modalfit/poles/doubled.hpp"
#include "modalfit/poles/exactness.hpp"
#include "modalfit/poles/prominence.hpp"
#include "modalfit/poles/refine.hpp"
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
constexpr double most_damping_deviation = 0.5;  ///< of the damping of a mode
constexpr double vague_lines = 4.0;             ///< lines per half width from which a mode must show its damping
/// A pole beyond the range that wanders longer has no place of its own.
constexpr std::size_t most_trial_iterations = 12;
constexpr double quiet = 1e-4;  ///< noise over modulus below which FRFs may be computed ones
constexpr double apart = 6.0;   ///< standard deviations between poles of such FRFs

/// Hysteretic η = 2ζ at resonance.
double damping_per_zeta(const ModelKind& kind) { return kind.damping == Damping::hysteretic ? 2.0 : 1.0; }

std::vector<std::size_t> all_entries(const Band& band) {
  std::vector<std::size_t> all(band.entries());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

std::vector<std::size_t> refined_entries(const Band& band, const FitOptions& options) {
  if (band.entries() <= options.most_refined) return all_entries(band);
  const InputChoice choice = choose_inputs(band, options.polyreference.inputs);
  const std::size_t step = (choice.outputs * choice.inputs.size() + options.most_refined - 1) / options.most_refined;
  std::vector<std::size_t> entries;
  for (std::size_t k = 0; k < choice.outputs * choice.inputs.size(); k += step) {
    entries.push_back(choice.entry(band, k / choice.inputs.size(), k % choice.inputs.size()));
  }
  return entries;
}

bool is_inside(const Pole& pole, const Band& band) {
  return pole.frequency_hz >= band.frequency_hz.front() && pole.frequency_hz <= band.frequency_hz.back();
}

/// How far beyond the ends of the range a mode can be told from a residual term.
bool is_near(const Pole& pole, const Band& band) {
  return pole.frequency_hz >= 0.5 * band.frequency_hz.front() && pole.frequency_hz <= 2.0 * band.frequency_hz.back();
}

class Fitter {
 public:
  Fitter(Band& band, const FitOptions& options) : band_(band), options_(options), entries_(refined_entries(band, options)) {}

  ModalFit run() {
    ModalFit out;
    if (options_.poles) {
      RefinedPoles given = refined_as_given(*options_.poles, out);
      finish(std::move(given), out);
      return out;
    }
    RefinedPoles refined = found(out);
    if (!stopped() && may_be_exact(refined)) seek_exact(refined, out);
    finish(std::move(refined), out);
    return out;
  }

 private:
  RefinedPoles found(ModalFit& out) {
    std::vector<Pole> poles = candidates({.most_damping = options_.most_damping}, out);
    tell("refining poles");
    RefinedPoles refined = settled(std::move(poles), false, out);
    add_peaks(refined, out);
    merge_doubled(refined, out);
    extend(refined, out);
    drop_vague(refined, out);
    return refined;
  }

  /// Whether neighbouring lines agree to digits that no measurement has although the model does not.
  bool may_be_exact(const RefinedPoles& refined) const {
    if (is_exact(band_, entries_, refined)) return false;
    const double rows = refined.freedom + 2.0 * static_cast<double>(refined.poles.size());
    return !band_.known_noise && rows > 0.0 && weighted_square(band_, entries_) > rows / (quiet * quiet);
  }

  /// FRFs without noise tell poles apart that noise would not, and poles beyond the range better: what follows them to their
  /// digits is taken.
  void seek_exact(RefinedPoles& refined, ModalFit& out) {
    ModalFit other;
    const std::vector<double> weight = band_.weight;
    RefinedPoles exact = settled(candidates({.most_damping = options_.most_damping, .apart = apart}, other), false, other);
    extend(exact, other);
    while (!is_exact(band_, entries_, exact) && split(exact, other)) extend(exact, other);
    add_peaks(exact, other);
    if (exact.converged && is_exact(band_, entries_, exact)) {
      refined = std::move(exact);
      out = std::move(other);
    } else {
      band_.weight = weight;
    }
  }

  void tell(const char* stage) const {
    if (options_.progress) options_.progress(stage);
  }
  bool stopped() const { return options_.interrupted && options_.interrupted(); }

  /// Rms residual over modulus.
  double deviation(const RefinedPoles& refined) const { return std::sqrt(refined.cost / weighted_square(band_, entries_)); }

  /// Two poles in place of the one on which the FRFs agree least; false, and all as before, when that does not halve the residuals.
  bool split(RefinedPoles& refined, ModalFit& out) {
    if (!refined.converged || refined.poles.empty() || stopped()) return false;
    const double before = deviation(refined);
    const std::vector<double> weight = band_.weight;
    for (const std::size_t r : least_agreed(refined)) {
      std::vector<Pole> poles = refined.poles;
      const double apart_hz = 0.5 * half_width_hz(options_.kind, poles[r]);
      poles.push_back({poles[r].frequency_hz + apart_hz, poles[r].damping});
      poles[r].frequency_hz -= apart_hz;
      RefinedPoles two = settled(std::move(poles), true, out);
      if (two.converged && two.poles.size() > refined.poles.size() && deviation(two) < 0.5 * before) {
        refined = std::move(two);
        return true;
      }
      band_.weight = weight;
    }
    return false;
  }

  /// The three poles inside of which single FRFs have the most different frequencies, in half widths.
  std::vector<std::size_t> least_agreed(const RefinedPoles& refined) const {
    const PoleScatter scatter = pole_scatter(band_, entries_, options_.kind, refined);
    std::vector<std::pair<double, std::size_t>> spread;
    for (std::size_t r = 0; r < refined.poles.size(); ++r) {
      if (!is_inside(refined.poles[r], band_)) continue;
      spread.emplace_back((scatter.own_hz[r][1] - scatter.own_hz[r][0]) / half_width_hz(options_.kind, refined.poles[r]), r);
    }
    std::ranges::sort(spread, std::greater{});
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, spread.size()); ++i) out.push_back(spread[i].second);
    return out;
  }

  std::vector<Pole> candidates(const ClusterOptions& clusters, ModalFit& out) {
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
  RefinedPoles refined_as_given(std::vector<Pole> poles, ModalFit& out) {
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
  RefinedPoles settled(std::vector<Pole> poles, bool beyond, ModalFit& out) {
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
  bool noise_agrees(const RefinedPoles& refined, double before) const {
    return band_.known_noise || !(std::abs(refined.cost - refined.freedom) > most_noise_change * refined.freedom) ||
           std::abs(refined.cost - before) <= most_noise_change * before;
  }

  static bool has_pole_at(const std::vector<Pole>& poles, const ModelKind& kind, const Pole& peak) {
    return std::ranges::any_of(poles, [&](const Pole& pole) {
      return std::abs(pole.frequency_hz - peak.frequency_hz) < 3.0 * (half_width_hz(kind, peak) + half_width_hz(kind, pole));
    });
  }

  /// Peaks of the residual FRFs become poles until none stands out. What a pole at the highest of them does not take is said.
  void add_peaks(RefinedPoles& refined, ModalFit& out) {
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
  void merge_doubled(RefinedPoles& refined, ModalFit& out) {
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
  void drop_vague(RefinedPoles& refined, ModalFit& out) {
    if (is_exact(band_, entries_, refined)) return;  // none is left over
    for (int round = 0; round < most_vague_rounds && refined.converged && !refined.poles.empty() && !stopped(); ++round) {
      const std::vector<std::string> why = objections(refined);
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

  /// [N] why a pole in the range is no mode, or nothing: its damping is hardly known though it spans many lines (a bend of the FRFs), or
  /// it rests on one line, or it changes no FRF by 1 dB at its own line (side bands of a resonance, say, by a swaying suspension).
  std::vector<std::string> objections(const RefinedPoles& refined) const {
    const double spacing = (band_.frequency_hz.back() - band_.frequency_hz.front()) / static_cast<double>(band_.lines() - 1);
    const std::size_t n = refined.poles.size();
    const PoleScatter scatter = pole_scatter(band_, entries_, options_.kind, refined);
    const double noise = chi_square_quantile(static_cast<double>(2 * entries_.size() + 2), significance_deviations) *
                         std::max(1.0, refined.freedom > 0.0 ? refined.cost / refined.freedom : 1.0);
    const std::vector<Prominence> prominence = prominences(band_, entries_, options_.kind, refined.poles);
    std::vector<std::string> out(n);
    for (std::size_t r = 0; r < n; ++r) {
      const Pole& pole = refined.poles[r];
      const std::size_t at = 2 * r + 1;
      if (!is_inside(pole, band_)) continue;
      const double deviation = scatter.factor[at] * std::sqrt(std::max(0.0, refined.covariance[at * 2 * n + at]));
      if (deviation > most_damping_deviation * pole.damping && half_width_hz(options_.kind, pole) > vague_lines * spacing) {
        out[r] = fmt::format("its {} is {:.2g} ± {:.2g} %", options_.kind.damping == Damping::hysteretic ? "η" : "ζ", 100.0 * pole.damping,
                             100.0 * deviation);
      } else if (prominence[r].flanks < noise) {
        out[r] = "it rests on a single line";
      } else if (!options_.modes && prominence[r].share < least_prominence) {
        out[r] = fmt::format("even in the FRF that shows it best it is {:.2g} % of the other terms, less than 1 dB",
                             100.0 * prominence[r].share);
      }
    }
    return out;
  }

  /// What is where modes are wanted, and significant.
  std::vector<Pole> select(std::vector<Pole> poles, bool beyond) const {
    const double most = options_.most_damping * damping_per_zeta(options_.kind);
    std::erase_if(poles, [&](const Pole& pole) {
      return pole.damping > most || !(is_inside(pole, band_) || (beyond && is_near(pole, band_)));
    });
    std::optional<std::size_t> count = options_.modes;
    if (count) *count += static_cast<std::size_t>(std::ranges::count_if(poles, [&](const Pole& pole) { return !is_inside(pole, band_); }));
    return significant_poles(band_, entries_, options_.kind, std::move(poles), count);
  }

  /// Tries a pole beyond each end of the range, and keeps what is significant, provided that the modes inside stay.
  void extend(RefinedPoles& refined, ModalFit& out) {
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
  bool add(const Pole& pole, RefinedPoles& refined, ModalFit& out) {
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

  std::size_t inside(const RefinedPoles& refined) const {
    return static_cast<std::size_t>(std::ranges::count_if(refined.poles, [&](const Pole& pole) { return is_inside(pole, band_); }));
  }

  void finish(RefinedPoles refined, ModalFit& out) {
    tell("residues");
    out.kind = options_.kind;
    out.known_noise = band_.known_noise;
    out.scale_hz = band_.scale_hz();
    out.cost = refined.cost;
    out.freedom = refined.freedom;
    out.refined_entries = entries_.size();
    const std::vector<std::size_t> all = all_entries(band_);
    const bool whole = entries_.size() == all.size();
    sort(refined);
    if (!band_.known_noise && !whole) estimate_noise(band_, all, options_.kind, refined.poles);
    const PoleScatter scatter = pole_scatter(band_, entries_, options_.kind, refined);
    widen(refined.covariance, scatter.factor);
    out.residues = fit_residues(band_, all, options_.kind, refined.poles, whole ? refined.covariance : std::vector<double>());
    fill_modes(refined, scatter, out);
    if (refined.poles.empty()) {
      out.status = FitStatus::no_modes;
      out.message = "No mode stands out of the noise: widen the range, or look at the FRFs.";
    } else if (!refined.converged) {
      out.status = FitStatus::not_converged;
      out.message = "The refinement of the poles did not settle: narrow the range, or say how many modes there are.";
    } else {
      doubt(out);
    }
  }

  void doubt(ModalFit& out) const {
    if (options_.modes && out.modes_inside() != *options_.modes) {
      out.message = fmt::format("{} modes were asked for, {} found: no other pole comes again from order to order or stands out as a peak.",
                                *options_.modes, out.modes_inside());
    } else if (!out.peaks_left_hz.empty()) {
      std::string where;
      for (const double f : out.peaks_left_hz) where += fmt::format("{}{:.6g}", where.empty() ? "" : ", ", f);
      out.message = "Peaks are left in the residual FRFs, at " + where + " Hz: " +
                    (options_.modes ? "ask for more modes, or narrow the range." : "narrow the range, and look at the FRFs there.");
    }
    if (!out.message.empty()) out.status = FitStatus::doubtful;
  }

  static void sort(RefinedPoles& refined) {
    const std::size_t n = refined.poles.size();
    std::vector<std::size_t> order(n);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t r) { return refined.poles[r].frequency_hz; });
    RefinedPoles sorted = refined;
    for (std::size_t i = 0; i < 2 * n; ++i) {
      sorted.poles[i / 2] = refined.poles[order[i / 2]];
      for (std::size_t j = 0; j < 2 * n; ++j) {
        sorted.covariance[i * 2 * n + j] = refined.covariance[(2 * order[i / 2] + i % 2) * 2 * n + 2 * order[j / 2] + j % 2];
      }
    }
    refined = std::move(sorted);
  }

  void fill_modes(const RefinedPoles& refined, const PoleScatter& scatter, ModalFit& out) const {
    const std::size_t n = refined.poles.size();
    const double coefficients = static_cast<double>(band_.entries() * (options_.kind.real_modes ? 1 : 2) + 2);
    const double least = chi_square_quantile(coefficients, significance_deviations) *
                         std::max(1.0, out.freedom > 0.0 ? out.cost / out.freedom : 1.0);
    out.pole_covariance = refined.covariance;
    for (std::size_t r = 0; r < n; ++r) {
      const auto variance = [&](std::size_t i) { return std::max(0.0, refined.covariance[i * 2 * n + i]); };
      out.modes.push_back({.pole = refined.poles[r],
                           .frequency_deviation_hz = refined.poles[r].frequency_hz * std::sqrt(variance(2 * r)),
                           .damping_deviation = std::sqrt(variance(2 * r + 1)),
                           .significance = out.residues.growth[r] / least,
                           .scatter = scatter.factor[2 * r],
                           .own_hz = scatter.own_hz[r],
                           .inside = is_inside(refined.poles[r], band_)});
    }
  }

  Band& band_;
  const FitOptions& options_;
  std::vector<std::size_t> entries_;
};

}  // namespace

std::string name(FitStatus status) {
  switch (status) {
    case FitStatus::no_modes: return "no_modes";
    case FitStatus::not_converged: return "not_converged";
    case FitStatus::doubtful: return "doubtful";
    case FitStatus::poor_fit: return "poor_fit";
    default: return "ok";
  }
}

bool is_usable(FitStatus status) { return status == FitStatus::ok || status == FitStatus::doubtful; }

std::vector<Pole> ModalFit::poles() const {
  std::vector<Pole> poles;
  for (const Mode& mode : modes) poles.push_back(mode.pole);
  return poles;
}

std::size_t ModalFit::modes_inside() const {
  return static_cast<std::size_t>(std::ranges::count(modes, true, &Mode::inside));
}

void judge(ModalFit& fit, double rms_db_away) {
  if (!is_usable(fit.status) || !(rms_db_away > most_synthesis_db)) return;
  fit.status = FitStatus::poor_fit;
  fit.message = fmt::format("The model is {:.2g} dB off away from antiresonances and noise: modes are missing, or the structure is not "
                            "that linear. {}", rms_db_away, fit.message);
  if (fit.message.back() == ' ') fit.message.pop_back();
}

ModalFit fit(Band& band, const frf::FrfHeader& header, const FitOptions& options) {
  const double unit = unit_of(band);
  multiply(band, 1.0 / unit);
  ModalFit out = Fitter(band, options).run();
  multiply(band, unit);
  out.residues.unit = unit;
  out.response = header.response;
  out.reference = header.reference;
  return out;
}

}  // namespace jointid::modalfit
