#include "modalfit/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "modalfit/clusters.hpp"
#include "modalfit/inputs.hpp"
#include "modalfit/noise_laws.hpp"
#include "modalfit/refine.hpp"
#include "modalfit/selection.hpp"

namespace jointid::modalfit {
namespace {

constexpr int most_rounds = 10;
constexpr double most_noise_change = 0.05;  ///< of the variances from round to round, where they are estimated
/// A pole beyond the range that wanders longer has no place of its own.
constexpr std::size_t most_trial_iterations = 12;

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
    std::vector<Pole> poles = candidates(out);
    tell("refining poles");
    RefinedPoles refined = settled(std::move(poles), false, out);
    extend(refined, out);
    finish(std::move(refined), out);
    return out;
  }

 private:
  void tell(const char* stage) const {
    if (options_.progress) options_.progress(stage);
  }
  bool stopped() const { return options_.interrupted && options_.interrupted(); }

  std::vector<Pole> candidates(ModalFit& out) {
    std::vector<Pole> poles;
    for (int pass = 0; pass < (band_.known_noise ? 1 : 2); ++pass) {
      tell("polyreference fit");
      out.stabilisation = polyreference_poles(band_, options_.polyreference);
      poles.clear();
      for (const Cluster& each : cluster(out.stabilisation, {.most_damping = options_.most_damping})) {
        poles.push_back({each.pole.frequency_hz, each.pole.damping * damping_per_zeta(options_.kind)});
      }
      if (!band_.known_noise) estimate_noise(band_, entries_, options_.kind, poles);
    }
    return poles;
  }

  /// Selects and refines until both agree.
  RefinedPoles settled(std::vector<Pole> poles, bool beyond, ModalFit& out) {
    RefinedPoles refined;
    for (int round = 0; round < most_rounds; ++round) {
      poles = select(poles, beyond);
      refined = refine(band_, entries_, options_.kind, poles, {}, options_.interrupted);
      out.iterations += refined.iterations;
      if (!band_.known_noise) estimate_noise(band_, entries_, options_.kind, refined.poles);
      poles = select(refined.poles, beyond);
      if ((poles.size() == refined.poles.size() && round > 0 && noise_agrees(refined)) || stopped()) break;
    }
    return refined;
  }

  /// Whether the weights of the refinement were those of the noise that it leaves.
  bool noise_agrees(const RefinedPoles& refined) const {
    return band_.known_noise || !(std::abs(refined.cost - refined.freedom) > most_noise_change * refined.freedom);
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
    const RefinedPoles first = refine(band_, entries_, options_.kind, std::move(poles), {.most_iterations = most_trial_iterations}, options_.interrupted);
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
    out.residues = fit_residues(band_, all, options_.kind, refined.poles, whole ? refined.covariance : std::vector<double>());
    fill_modes(refined, out);
    if (refined.poles.empty()) {
      out.status = FitStatus::no_modes;
      out.message = "No mode stands out of the noise: widen the range, or look at the FRFs.";
    } else if (!refined.converged) {
      out.status = FitStatus::not_converged;
      out.message = "The refinement of the poles did not settle: narrow the range, or say how many modes there are.";
    }
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

  void fill_modes(const RefinedPoles& refined, ModalFit& out) const {
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
    default: return "ok";
  }
}

std::vector<Pole> ModalFit::poles() const {
  std::vector<Pole> poles;
  for (const Mode& mode : modes) poles.push_back(mode.pole);
  return poles;
}

std::size_t ModalFit::modes_inside() const {
  return static_cast<std::size_t>(std::ranges::count(modes, true, &Mode::inside));
}

ModalFit fit(Band& band, const frf::FrfHeader& header, const FitOptions& options) {
  ModalFit out = Fitter(band, options).run();
  out.response = header.response;
  out.reference = header.reference;
  return out;
}

}  // namespace jointid::modalfit
