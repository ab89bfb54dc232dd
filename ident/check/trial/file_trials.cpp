#include "ident/check/trial/file_trials.hpp"

#include <algorithm>
#include <cmath>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "base/text.hpp"
#include "ident/check/test/delay_fit.hpp"
#include "ident/check/trial/mistaken_units.hpp"

namespace jointid::ident {
namespace {

using Files = std::vector<CheckedFile>;

template <class Factor>
void scale_lines(CheckedFile& file, Factor factor) {
  for (std::size_t l = 0; l < file.frfs.size(); ++l) file.frfs[l] *= factor(angular(file.frequency_hz[l]));
}

void conjugate_file(CheckedFile& file) {
  for (Eigen::MatrixXcd& line : file.frfs) line = line.conjugate().eval();
}

void take_out_mass(CheckedFile& file, double mass) {
  for (std::size_t l = 0; l < file.frfs.size(); ++l) {
    const double square = -std::pow(angular(file.frequency_hz[l]), 2);
    for (std::size_t r = 0; r < file.responses.size(); ++r) {
      const std::size_t c = place_of(file.references, file.responses[r]);
      if (c == frf::npos || file.responses[r].is_rotation()) continue;
      const auto row = at(r);
      const std::complex<double> point = file.frfs[l](row, at(c));
      file.frfs[l].row(row) /= 1.0 - square * mass * point;
    }
  }
}

MistakeTrial file_gain_trial(const Files& files, std::size_t f, double measured) {
  const UnitFactor unit = nearest_unit(measured, 0.03);
  const std::string& words = unit.words;
  return {.kind = words.empty() ? SuspectKind::gain : SuspectKind::unit,
          .files = {f},
          .dofs = {},
          .what = "all FRFs of the file are off by the factor " + digits(1.0 / measured, "%.4g") +
                  (words.empty() ? "" : ": " + words),
          .remedy = remedy_in(files[f].name, "gain = " + digits(unit.factor, "%.6g")),
          .undo = [f, factor = unit.factor](Files& all) { scale_lines(all[f], [&](double) { return factor; }); }};
}

MistakeTrial delay_trial(const Files& files, std::size_t f, double delay) {
  return {.kind = SuspectKind::delay,
          .files = {f},
          .dofs = {},
          .what = "the phases of all FRFs of the file fall with frequency as if the responses came " + digits(delay * 1e6, "%.3g") +
                  " µs late",
          .remedy = remedy_in(files[f].name, "delay = " + digits(delay, "%.3g")),
          .undo = [f, delay](Files& all) { scale_lines(all[f], [&](double omega) { return std::polar(1.0, omega * delay); }); }};
}

/// The file holds what it says times (iω)^−power.
MistakeTrial quantity_trial(const Files& files, std::size_t f, int power) {
  const int stored = static_cast<int>(files[f].quantity), is = stored - power;
  const auto word = [](int q) { return frf::name(static_cast<frf::Quantity>(q)); };
  return {.kind = SuspectKind::quantity,
          .files = {f},
          .dofs = {},
          .what = "the FRFs grow with frequency and turn by quarters as " + word(is) + " does, not " + word(stored),
          .remedy = remedy_in(files[f].name, "quantity = \"" + word(is) + "\""),
          .undo = [f, power](Files& all) {
            scale_lines(all[f], [&](double omega) { return std::pow(std::complex<double>(0.0, omega), power); });
          }};
}

MistakeTrial conjugate_trial(const Files& files, std::size_t f) {
  return {.kind = SuspectKind::conjugate,
          .files = {f},
          .dofs = {},
          .what = "the imaginary parts have the other sign: driving points are not passive",
          .remedy = remedy_in(files[f].name, "conjugate = true"),
          .undo = [f](Files& all) { conjugate_file(all[f]); }};
}

MistakeTrial file_sign_trial(const Files& files, std::size_t f) {
  const std::string names = comma_list(files[f].references, quoted_dof);
  return {.kind = SuspectKind::sign,
          .files = {f},
          .dofs = {},
          .what = "all FRFs of the file have the other sign: the hammer's or shaker's force cell",
          .remedy = remedy_in(files[f].name, "flip_reference = [" + names + "]"),
          .undo = [f](Files& all) { scale_lines(all[f], [](double) { return -1.0; }); }};
}

/// One undo for all files; the suspect is told of the first, and the others follow in the rounds after it.
MistakeTrial for_all(const Files& files, const std::function<MistakeTrial(std::size_t)>& make) {
  MistakeTrial result = make(0);
  result.files.clear();
  std::vector<std::function<void(Files&)>> undo;
  std::string remedy;
  for (std::size_t f = 0; f < files.size(); ++f) {
    const MistakeTrial each = make(f);
    undo.push_back(each.undo);
    remedy += (remedy.empty() ? "" : "\n") + each.remedy;
    result.files.push_back(f);
  }
  result.what = "in all files, " + result.what;
  result.remedy = remedy;
  result.undo = [undo](Files& all) {
    for (const auto& each : undo) each(all);
  };
  return result;
}

bool is_a_quantity(const CheckedFile& file, int power) {
  const int is = static_cast<int>(file.quantity) - power;
  return is >= 0 && is <= 2;
}

struct RatioFinding {
  double size = 1.0, delay = 0.0, deviation = 0.0;  ///< of the assembly over the part
  /// Standard deviations by which ln size is off 0, beyond what noise in one of the two files could make of it; 0 within that and where it
  /// may be chance.
  double deviations = 0.0;
  bool known = false;
};

RatioFinding ratio_of(const SpanTest& test, double tried) {
  RatioFinding out;
  std::vector<double> sizes, noise;
  std::vector<PhaseSample> samples;
  for (std::size_t l = 0; l < test.ratio.size(); ++l) {
    if (test.coherence[l] < 0.5) continue;
    sizes.push_back(std::log(std::abs(test.ratio[l])));
    noise.push_back(-0.5 * std::log(std::min(test.coherence[l], 1.0)));
    samples.push_back({angular(test.ratio_hz[l]), test.ratio[l] / std::abs(test.ratio[l]) * test.coherence[l]});
  }
  if (sizes.size() < 4) return out;
  const double middle = median(sizes);
  out.size = std::exp(middle);
  std::vector<double> off;
  for (const double size : sizes) off.push_back(std::abs(size - middle));
  const auto count = static_cast<double>(sizes.size());
  const double error = 1.86 * median(off) / std::sqrt(count);
  out.deviations = std::max(0.0, (std::abs(middle) - median(noise)) / std::hypot(error, 3e-4));
  if (may_be_chance(out.deviations, freedom_of_median(count), tried)) out.deviations = 0.0;
  const DelayFit fit = fit_delay(samples);
  out.delay = fit.delay;
  out.deviation = fit.deviation;
  out.known = true;
  return out;
}

/// Beyond half a microsecond and chance.
bool is_delay(double delay, double deviation) { return std::abs(delay) > 5e-7 && std::abs(delay) > 5.0 * deviation; }

/// Gains and delays of the assembly against its parts.
void add_ratio_trials(const Files& files, const std::vector<SpanSetup>& setups, const Screening& screening,
                      std::vector<MistakeTrial>& out) {
  std::vector<bool> scaled(files.size(), false), seen_delay(files.size(), false);
  for (std::size_t s = 0; s < setups.size(); ++s) {
    const RatioFinding ratio = ratio_of(screening.span[s], screening.chosen_from * static_cast<double>(setups.size()));
    if (!ratio.known) continue;
    for (const std::size_t f : {setups[s].part, setups[s].assembly}) {
      const double to_mend = f == setups[s].part ? ratio.size : 1.0 / ratio.size;
      const bool small = std::abs(std::log(to_mend)) <= 0.02;
      if ((!small || ratio.deviations > significant_span) && !scaled[f]) {
        out.push_back(file_gain_trial(files, f, to_mend));
        if (small) out.back().bonus = 0.02 * std::min(ratio.deviations, 40.0);
        scaled[f] = true;
      }
      if (is_delay(ratio.delay, ratio.deviation) && !seen_delay[f]) {
        out.push_back(delay_trial(files, f, f == setups[s].part ? -ratio.delay : ratio.delay));
        seen_delay[f] = true;
      }
    }
  }
}

/// Signs, conjugates, delays and quantities of one file. `is_far`: whether some span test leaves much.
void add_trials_of(const Files& files, std::size_t f, const PhaseTest& phase, const Misfit& misfit, bool is_far,
                   std::vector<MistakeTrial>& out) {
  const bool active = misfit.active[f] > 0.0, imaginary = misfit.imaginary[f] > 1.0;
  if (active || is_far) {
    out.push_back(conjugate_trial(files, f));
    out.push_back(file_sign_trial(files, f));
  }
  if (active || is_delay(phase.delay, phase.delay_deviation)) out.push_back(delay_trial(files, f, phase.delay));
  if (!imaginary && !active && !is_far) return;
  for (const int power : {-2, -1, 1, 2}) {
    if (is_a_quantity(files[f], power)) out.push_back(quantity_trial(files, f, power));
  }
}

/// The mass of a sensor that moves with the response. `tried`: as many might have been found.
void add_mass_trial(const Files& files, std::size_t f, const ReciprocityTest& mirror, double tried, std::vector<MistakeTrial>& out) {
  if (!(mirror.mass > 0.0 && mirror.mass > 4.0 * mirror.mass_deviation && mirror.level > 0.01)) return;
  if (may_be_chance(mirror.mass / mirror.mass_deviation, mirror.mass_freedom, tried)) return;
  std::string masses;
  for (const frf::Dof& dof : mirror.dofs) {
    if (!dof.is_rotation()) masses += (masses.empty() ? "" : ", ") + quoted_dof(dof) + " = " + digits(mirror.mass, "%.3g");
  }
  out.push_back({.kind = SuspectKind::mass,
                 .files = {f},
                 .dofs = {},
                 .what = "H_ij and H_ji differ as if a sensor of " + digits(mirror.mass * 1e3, "%.3g") + " g moved with the response",
                 .remedy = remedy_in(files[f].name, "sensor_mass = { " + masses + " }"),
                 .undo = [f, m = mirror.mass](Files& all) { take_out_mass(all[f], m); },
                 .bonus = 0.01 * std::min(mirror.mass / mirror.mass_deviation, 25.0)});
}

/// What all files have in common.
void add_trials_of_all(const Files& files, const Screening& screening, const Misfit& misfit, std::vector<MistakeTrial>& out) {
  const bool any_active = std::ranges::any_of(misfit.active, [](double each) { return each > 0.0; });
  const bool any_imaginary = std::ranges::any_of(misfit.imaginary, [](double each) { return each > 1.0; });
  const bool all_delayed =
      std::ranges::all_of(screening.phase, [](const PhaseTest& each) { return is_delay(each.delay, each.delay_deviation); });
  if (any_active) out.push_back(for_all(files, [&](std::size_t f) { return conjugate_trial(files, f); }));
  if (any_active && all_delayed) {
    out.push_back(for_all(files, [&](std::size_t f) { return delay_trial(files, f, screening.phase[f].delay); }));
  }
  for (const int power : {-1, 1}) {
    const bool possible = std::ranges::all_of(files, [&](const CheckedFile& file) { return is_a_quantity(file, power); });
    if (any_imaginary && possible) out.push_back(for_all(files, [&](std::size_t f) { return quantity_trial(files, f, power); }));
  }
}

}  // namespace

std::vector<MistakeTrial> file_trials(const Files& files, const std::vector<SpanSetup>& setups, const Screening& screening,
                                      const Misfit& misfit) {
  std::vector<MistakeTrial> out;
  add_ratio_trials(files, setups, screening, out);
  const double worst = misfit.span.empty() ? 1.0 : *std::ranges::max_element(misfit.span);
  for (std::size_t f = 0; f < files.size(); ++f) {
    add_trials_of(files, f, screening.phase[f], misfit, worst > large_misfit, out);
    add_mass_trial(files, f, screening.reciprocity[f], screening.chosen_from * static_cast<double>(files.size()), out);
  }
  add_trials_of_all(files, screening, misfit, out);
  return out;
}

std::vector<MistakeTrial> exchange_trials(const Files& files) {
  std::vector<MistakeTrial> out;
  for (std::size_t a = 0; a < files.size(); ++a) {
    for (std::size_t b = a + 1; b < files.size(); ++b) {
      if (files[a].assembly || files[b].assembly || files[a].responses.size() != files[b].responses.size() ||
          files[a].references.size() != files[b].references.size()) {
        continue;
      }
      out.push_back({.kind = SuspectKind::exchange,
                     .files = {a, b},
                     .dofs = {},
                     .what = "the FRFs fit the labels of " + files[b].name + ", and those of that file fit the labels here",
                     .remedy = "exchange the FRFs of the files " + files[a].name + " and " + files[b].name,
                     .undo = [a, b](Files& all) { std::swap(all[a].frfs, all[b].frfs); }});
    }
  }
  return out;
}

}  // namespace jointid::ident
