#include "ident/check/trial/gain_trials.hpp"

#include <algorithm>
#include <cmath>

#include "base/statistics.hpp"
#include "base/text.hpp"
#include "ident/check/trial/measured_channel.hpp"

namespace jointid::ident {
namespace {

using Files = std::vector<CheckedFile>;

constexpr double significant_mirror = 4.5;  ///< standard deviations, of H_ij against H_ji
constexpr double least_gain_error = 0.006;

/// Where a factor is a matter of calibration: the section that lets method "likelihood" find it, as comments for whoever prefers that to
/// the number. Its prior is twice as wide as the factor is off.
std::string gain_as_unknown(const std::string& file, const MeasuredChannel& c, double factor) {
  constexpr double calibration = 0.1;
  const double off = std::abs(factor - 1.0);
  if (off > calibration) return "";
  return "\n# or, as an unknown of method \"likelihood\":\n# [[data.gains]]\n# dofs = [" + quoted_dof(c.dof) + "]\n# files = [\"" + file +
         "\"]\n" + (c.role == Role::reference ? "# role = \"reference\"\n" : "") + "# gain = " + digits(2.0 * off, "%.1g");
}

MistakeTrial gain_trial(const Files& files, const MeasuredChannel& c, double factor) {
  return {.kind = SuspectKind::gain,
          .files = {c.file},
          .dofs = {c.dof},
          .what = "the " + channel_word(c.role) + " at " + c.dof.name() + " reads " + digits(1.0 / factor, "%.4g") +
                  " times what it should",
          .remedy = remedy_in(files[c.file].name,
                              role_key("gain", c.role) + " = { " + quoted_dof(c.dof) + " = " + digits(factor, "%.5g") + " }" +
                                  gain_as_unknown(files[c.file].name, c, factor)),
          .undo = [c, factor](Files& all) { scale_channel(all[c.file], c.role, c.dof, factor); }};
}

/// A factor and how many standard deviations it is away from 1; 0 where that may be chance.
struct GainFinding {
  double factor = 1.0, deviations = 0.0;
  bool weighed = false;  ///< by covariances of the files: deviations are told by what a row has of its own

  GainFinding beyond_chance(double freedom, double tried) const {
    return {factor, may_be_chance(deviations, freedom, tried) ? 0.0 : deviations, weighed};
  }
};

/// How many gains of channels are looked at.
double gains_tried(const std::vector<SpanSetup>& setups, const Screening& screening) {
  std::size_t count = 0;
  for (const SpanSetup& setup : setups) count += setup.rows.size();
  for (const ReciprocityTest& test : screening.reciprocity) count += test.dofs.size();
  return screening.chosen_from * static_cast<double>(count);
}

/// Of a row of a span test, against the spread of the other rows' factors. Where rows are weighed, what all of them are off by is what
/// noise in the FRFs does to factors; their spread does not count, as a row that is off draws the others along: they are known well
/// enough to tell it by their deviations.
GainFinding gain_of_row(const SpanTest& test, std::size_t k, bool weighed) {
  const double middle = median(test.gain);
  std::vector<double> off;
  for (const double gain : test.gain) off.push_back(std::abs(gain - middle));
  const bool many = test.gain.size() > 3;
  if (weighed && many) {
    constexpr double unknown = 0.002;
    const double factor = test.gain[k] / middle;
    return {factor, std::abs(factor - 1.0) / std::hypot(test.deviation[k], unknown), true};
  }
  const double spread = many ? 1.48 * median(off) : 0.0;
  return {test.gain[k], std::abs(test.gain[k] - 1.0) / std::hypot(test.deviation[k], spread, 5e-4)};
}

GainFinding gain_by_reciprocity(const ReciprocityTest& test, const frf::Dof& dof) {
  const std::size_t k = place_of(test.dofs, dof);
  if (k == frf::npos || test.dofs.size() < 4) return {};
  return {test.gain[k], std::abs(std::log(test.gain[k])) / std::hypot(test.deviation[k], 5e-4)};
}

/// Which reciprocity factor a channel's own role makes of it.
double in_role(double factor, Role role) { return role == Role::response ? factor : 1.0 / factor; }

void add_gain_trial(const Files& files, const MeasuredChannel& c, const GainFinding& of_span, const GainFinding& of_mirror,
                    std::vector<MistakeTrial>& out) {
  const bool by_mirror = of_mirror.deviations >= significant_mirror;
  const double factor =
      by_mirror && of_mirror.deviations > of_span.deviations ? in_role(of_mirror.factor, c.role) : of_span.factor;
  if (!(factor > 0.0 && std::abs(factor - 1.0) >= least_gain_error)) return;
  MistakeTrial trial = gain_trial(files, c, factor);
  const double by_span = of_span.weighed ? 0.07 * std::min(of_span.deviations, 15.0) : 0.02 * std::min(of_span.deviations, 40.0);
  trial.bonus = by_span + 0.08 * std::min(of_mirror.deviations, 10.0);
  out.push_back(std::move(trial));
}

}  // namespace

std::vector<MistakeTrial> gain_trials(const Files& files, const std::vector<SpanSetup>& setups, const Screening& screening) {
  std::vector<MistakeTrial> out;
  MeasuredChannels done;
  const double tried = gains_tried(setups, screening);
  const auto by_mirror = [&](std::size_t file, const frf::Dof& dof) {
    const ReciprocityTest& test = screening.reciprocity[file];
    const std::size_t k = place_of(test.dofs, dof);
    return gain_by_reciprocity(test, dof).beyond_chance(k == frf::npos ? 0.0 : test.freedom[k], tried);
  };
  for (std::size_t s = 0; s < setups.size(); ++s) {
    const Role role = setups[s].transposed ? Role::reference : Role::response;
    for (std::size_t k = 0; k < setups[s].rows.size(); ++k) {
      const GainFinding found =
          gain_of_row(screening.span[s], k, setups[s].weighed).beyond_chance(screening.span[s].freedom[k], tried);
      for (const std::size_t file : {setups[s].assembly, setups[s].part}) {
        const frf::Dof& dof = setups[s].rows[k];
        const GainFinding mirror = by_mirror(file, dof);
        if (found.deviations < significant_span && mirror.deviations < significant_mirror) continue;
        GainFinding own = found;
        if (file == setups[s].part) own.factor = 1.0 / own.factor;
        const std::size_t before = done.channels.size();
        done.add(files, file, role, dof);
        if (done.channels.size() > before) add_gain_trial(files, {file, role, dof}, own, mirror, out);
      }
    }
  }
  for (std::size_t f = 0; f < files.size(); ++f) {
    for (const frf::Dof& dof : screening.reciprocity[f].dofs) {
      const GainFinding mirror = by_mirror(f, dof);
      const std::size_t before = done.channels.size();
      if (mirror.deviations >= significant_mirror) done.add(files, f, Role::response, dof);
      if (done.channels.size() > before) add_gain_trial(files, {f, Role::response, dof}, {}, mirror, out);
    }
  }
  return out;
}

}  // namespace jointid::ident
