#include "modalfit/model/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "modalfit/band/inputs.hpp"
#include "modalfit/model/appearance.hpp"
#include "modalfit/model/noise_laws.hpp"
#include "modalfit/model/pole_search.hpp"
#include "modalfit/model/uncertainty.hpp"
#include "modalfit/poles/exactness.hpp"
#include "modalfit/poles/refine.hpp"
#include "modalfit/poles/selection.hpp"

namespace jointid::modalfit {
namespace {

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

constexpr double much_misfit = 2.0, much_less = 0.25;  ///< mean square of residuals
constexpr std::size_t other_iterations = 6;

class Fitter {
 public:
  Fitter(Band& band, const FitOptions& options) : band_(band), options_(options), entries_(refined_entries(band, options)) {}

  ModalFit run() {
    ModalFit out;
    PoleSearch search(band_, options_, entries_);
    finish(options_.poles ? search.as_given(*options_.poles, out) : search.run(out), out);
    return out;
  }

 private:
  void tell(const char* stage) const {
    if (options_.progress) options_.progress(stage);
  }

  void finish(RefinedPoles refined, ModalFit& out) {
    tell("residues");
    out.kind = options_.kind;
    out.known_noise = band_.known_noise;
    out.scale_hz = band_.scale_hz();
    out.cost = refined.cost;
    out.freedom = refined.freedom;
    out.deviation = deviation(band_, entries_, options_.kind, refined.poles);
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
      out.status = Status::no_modes;
      out.message = "No mode exceeds the noise: widen the range, or look at the FRFs.";
    } else if (!refined.converged) {
      out.status = Status::not_converged;
      out.message = "The refinement of the poles did not converge: narrow the range, or give the number of modes.";
    } else {
      doubt(out);
      compare_damping(refined, out);
      tell_misfit(out);
    }
  }

  /// Says so where the other law of damping follows the FRFs much better.
  void compare_damping(const RefinedPoles& refined, ModalFit& out) const {
    if (!(out.cost > much_misfit * out.freedom) || (options_.interrupted && options_.interrupted())) return;
    const bool viscous = options_.kind.damping == Damping::viscous;
    const ModelKind kind{viscous ? Damping::hysteretic : Damping::viscous, options_.kind.real_modes};
    std::vector<Pole> poles = refined.poles;
    for (Pole& pole : poles) pole.damping *= damping_per_zeta(kind) / damping_per_zeta(options_.kind);
    const RefinedPoles other = refine(band_, entries_, kind, std::move(poles), {.most_iterations = other_iterations}, options_.interrupted);
    if (!(other.cost < much_less * out.cost)) return;
    out.remarks.push_back(
        fmt::format("With {0} damping (--damping {0}) the mean square of the residuals is {1:.2g} in place of {2:.2g}: that "
                    "law follows the FRFs better.",
                    name(kind.damping), other.cost / out.freedom, out.cost / out.freedom));
  }

  /// FRFs whose lines agree to digits that no measurement has, and a model that leaves more.
  void tell_misfit(ModalFit& out) const {
    constexpr double far_above = 3.0, told_from = 1e-9;
    const double noise = relative_noise(band_, entries_);
    if (band_.known_noise || !(noise < quiet_noise) ||
        !(out.deviation > std::max(told_from, far_above * std::max(noise, band_.precision))))
      return;
    if (!out.message.empty()) return;
    out.message = fmt::format(
        "The model leaves {:.2g} of the FRFs, which agree from line to line to {:.2g}: this is no noise. Frequencies may be "
        "off by as much of a half-power bandwidth. Modes beyond the range do more in it than the model follows: widen the range.",
        out.deviation, std::max(noise, band_.precision));
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
    if (!out.message.empty()) out.status = Status::doubtful;
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

void judge(ModalFit& fit, double rms_db_away) {
  if (!is_usable(fit.status) || !(rms_db_away > most_synthesis_db)) return;
  fit.status = Status::poor_fit;
  fit.message = fmt::format("The model is {:.2g} dB off away from antiresonances and noise: modes are missing, or the structure is not "
                            "that linear. {}", rms_db_away, fit.message);
  if (fit.message.back() == ' ') fit.message.pop_back();
}

ModalFit fit(Band& band, const frf::FrfHeader& header, const FitOptions& options) {
  const double unit = unit_of(band);
  multiply(band, 1.0 / unit);
  ModalFit out = Fitter(band, options).run();
  doubt_phase(out, band);
  if (out.status == Status::no_modes || out.status == Status::not_converged) explain(out, band, options);
  multiply(band, unit);
  out.residues.unit = unit;
  out.response = header.response;
  out.reference = header.reference;
  return out;
}

}  // namespace jointid::modalfit
