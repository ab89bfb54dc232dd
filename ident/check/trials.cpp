#include "ident/check/trials.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/complex.hpp"
#include "base/eigen.hpp"
#include "base/parallel.hpp"
#include "base/statistics.hpp"
#include "base/text.hpp"
#include "ident/check/delay_fit.hpp"

namespace jointid::ident {
namespace {

struct Mistaken {
  double factor;
  const char* words;
};

constexpr std::array<Mistaken, 9> mistaken_units = {{{9.80665, "g in place of m/s²"},
                                                     {1e-3, "mm in place of m"},
                                                     {1e-6, "µm in place of m"},
                                                     {0.0254, "inches in place of m"},
                                                     {0.3048, "feet in place of m"},
                                                     {1.0 / 4.4482216, "pounds of force in place of N"},
                                                     {386.0886, "g taken for in/s²"},
                                                     {9806.65, "g taken for mm/s²"},
                                                     {0.01, "cm in place of m"}}};

using Files = std::vector<CheckedFile>;

constexpr double large_misfit = 0.08;  ///< above it, signs and labels of single channels are tried
constexpr double unknown_noise = 1e9, usual_noise = 0.05;
constexpr double significant = 6.0, significant_mirror = 4.5;  ///< standard deviations, of span tests and of H_ij against H_ji
constexpr double least_gain_error = 0.006;
constexpr std::size_t candidates_per_test = 3, all_partners = 14;

std::string quoted_dof(const frf::Dof& dof) { return "\"" + dof.name() + "\""; }

/// One role of a channel: sensor (response) or hammer (reference).
enum class Role { response, reference };

struct MeasuredChannel {
  std::size_t file;
  Role role;
  frf::Dof dof;
};

const Dofs& dofs_of(const CheckedFile& file, Role role) { return role == Role::response ? file.responses : file.references; }

bool has_role(const CheckedFile& file, Role role, const frf::Dof& dof) { return place_of(dofs_of(file, role), dof) != frf::npos; }

/// Nothing where the file, a group of references for example, does not have the channel.
void scale_channel(CheckedFile& file, Role role, const frf::Dof& dof, std::complex<double> factor) {
  if (!has_role(file, role, dof)) return;
  const auto at = static_cast<Eigen::Index>(place_of(dofs_of(file, role), dof));
  for (Eigen::MatrixXcd& line : file.frfs) {
    if (role == Role::response) {
      line.row(at) *= factor;
    } else {
      line.col(at) *= factor;
    }
  }
}

/// Nothing where the file does not have both.
void swap_channels(CheckedFile& file, Role role, const frf::Dof& a, const frf::Dof& b) {
  if (!has_role(file, role, a) || !has_role(file, role, b)) return;
  const auto i = static_cast<Eigen::Index>(place_of(dofs_of(file, role), a)),
             j = static_cast<Eigen::Index>(place_of(dofs_of(file, role), b));
  for (Eigen::MatrixXcd& line : file.frfs) {
    if (role == Role::response) {
      line.row(i).swap(line.row(j));
    } else {
      line.col(i).swap(line.col(j));
    }
  }
}

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

/// The rows that a span test would rather be without, and the coordinates whose pairs are least reciprocal.
struct Candidates {
  std::vector<MeasuredChannel> channels;

  void add(const Files& files, std::size_t file, Role role, const frf::Dof& dof) {
    const auto same = [&](const MeasuredChannel& c) { return c.file == file && c.role == role && c.dof.same_coordinate(dof); };
    if (has_role(files[file], role, dof) && std::ranges::none_of(channels, same)) channels.push_back({file, role, dof});
  }
};

/// The few largest, as long as they are not much below the largest.
std::vector<std::size_t> outstanding(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
  order.resize(std::min(order.size(), candidates_per_test));
  const double least = order.empty() ? 0.0 : 0.25 * values[order.front()];
  std::erase_if(order, [&](std::size_t k) { return values[k] < least; });
  return order;
}

/// Tests that are worse than others, whose channels may be wrong; all where none is.
std::vector<bool> standing_out(const std::vector<double>& levels) {
  std::vector<bool> out(levels.size());
  const double least = levels.empty() ? 0.0 : *std::ranges::min_element(levels);
  for (std::size_t i = 0; i < levels.size(); ++i) out[i] = levels[i] > large_misfit || levels[i] > 2.5 * least;
  if (std::ranges::none_of(out, [](bool each) { return each; })) out.assign(levels.size(), true);
  return out;
}

Candidates candidate_channels(const Files& files, const std::vector<SpanSetup>& setups, const Screening& screening) {
  Candidates found;
  std::vector<double> levels;
  for (const SpanTest& test : screening.span) levels.push_back(test.level);
  const std::vector<bool> worse = standing_out(levels);
  for (std::size_t s = 0; s < setups.size(); ++s) {
    if (!worse[s]) continue;
    const Role role = setups[s].transposed ? Role::reference : Role::response;
    for (const std::size_t k : outstanding(screening.span[s].share)) {
      found.add(files, setups[s].assembly, role, setups[s].rows[k]);
      found.add(files, setups[s].part, role, setups[s].rows[k]);
    }
  }
  for (std::size_t f = 0; f < files.size(); ++f) {
    const double usual = median(screening.reciprocity[f].row);
    for (const std::size_t k : outstanding(screening.reciprocity[f].row)) {
      if (screening.reciprocity[f].row[k] < 2.0 * usual) continue;
      found.add(files, f, Role::response, screening.reciprocity[f].dofs[k]);
      found.add(files, f, Role::reference, screening.reciprocity[f].dofs[k]);
    }
  }
  return found;
}

std::string channel_word(Role role) { return role == Role::response ? "sensor" : "hammer or shaker"; }
std::string role_key(const char* key, Role role) { return std::string(key) + (role == Role::response ? "" : "_reference"); }

MistakeTrial sign_trial(const Files& files, const MeasuredChannel& c) {
  return {.kind = SuspectKind::sign,
          .files = {c.file},
          .dofs = {c.dof},
          .what = "the " + channel_word(c.role) + " at " + c.dof.name() + " points the other way",
          .remedy = remedy_in(files[c.file].name, role_key("flip", c.role) + " = [" + quoted_dof(c.dof) + "]"),
          .undo = [c](Files& all) { scale_channel(all[c.file], c.role, c.dof, -1.0); }};
}

MistakeTrial both_signs_trial(const Files& files, std::size_t file, const frf::Dof& dof) {
  const std::string name = quoted_dof(dof);
  return {.kind = SuspectKind::sign,
          .files = {file},
          .dofs = {dof},
          .what = "the direction of " + dof.name() + " is the other one, of sensor and excitation",
          .remedy = remedy_in(files[file].name, "flip = [" + name + "]\nflip_reference = [" + name + "]"),
          .undo = [file, dof](Files& all) {
            scale_channel(all[file], Role::response, dof, -1.0);
            scale_channel(all[file], Role::reference, dof, -1.0);
          }};
}

std::string swap_line(Role role, const frf::Dof& a, const frf::Dof& b) {
  return role_key("rename", role) + " = { " + quoted_dof(a) + " = " + quoted_dof(b) + ", " + quoted_dof(b) + " = " +
         quoted_dof(a) + " }";
}

MistakeTrial swap_trial(const Files& files, const MeasuredChannel& c, const frf::Dof& other) {
  return {.kind = SuspectKind::swap,
          .files = {c.file},
          .dofs = {c.dof, other},
          .what = "the labels of " + c.dof.name() + " and " + other.name() + " are exchanged (" + channel_word(c.role) + "s)",
          .remedy = remedy_in(files[c.file].name, swap_line(c.role, c.dof, other)),
          .undo = [c, other](Files& all) { swap_channels(all[c.file], c.role, c.dof, other); }};
}

MistakeTrial both_swapped_trial(const Files& files, std::size_t file, const frf::Dof& a, const frf::Dof& b) {
  return {.kind = SuspectKind::swap,
          .files = {file},
          .dofs = {a, b},
          .what = "the labels of " + a.name() + " and " + b.name() + " are exchanged, of sensors and excitation",
          .remedy = remedy_in(files[file].name, swap_line(Role::response, a, b) + "\n" + swap_line(Role::reference, a, b)),
          .undo = [file, a, b](Files& all) {
            swap_channels(all[file], Role::response, a, b);
            swap_channels(all[file], Role::reference, a, b);
          }};
}

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

void add_channel_trials(const Files& files, const Candidates& candidates, std::vector<MistakeTrial>& out) {
  for (const MeasuredChannel& c : candidates.channels) {
    const Dofs& own = dofs_of(files[c.file], c.role);
    const bool both = c.role == Role::response && has_role(files[c.file], Role::reference, c.dof);
    out.push_back(sign_trial(files, c));
    if (both) out.push_back(both_signs_trial(files, c.file, c.dof));
    const auto is_candidate = [&](const frf::Dof& dof) {
      return std::ranges::any_of(candidates.channels, [&](const MeasuredChannel& o) {
        return o.file == c.file && o.role == c.role && o.dof.same_coordinate(dof);
      });
    };
    for (const frf::Dof& other : own) {
      if (other.same_coordinate(c.dof)) continue;
      const bool listed = is_candidate(other);
      if (own.size() > all_partners && !listed) continue;
      if (listed && frf::coordinate_key(other) < frf::coordinate_key(c.dof)) continue;  // once per pair
      out.push_back(swap_trial(files, c, other));
      if (both && listed && has_role(files[c.file], Role::reference, other))
        out.push_back(both_swapped_trial(files, c.file, c.dof, other));
    }
  }
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

void add_gain_trials(const Files& files, const std::vector<SpanSetup>& setups, const Screening& screening,
                     std::vector<MistakeTrial>& out) {
  Candidates done;
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
        if (found.deviations < significant && mirror.deviations < significant_mirror) continue;
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

void add_file_trials(const Files& files, const std::vector<SpanSetup>& setups, const Screening& screening, const Misfit& misfit,
                     std::vector<MistakeTrial>& out) {
  const auto is_delay = [](double delay, double deviation) {
    return std::abs(delay) > 5e-7 && std::abs(delay) > 5.0 * deviation;
  };
  std::vector<bool> scaled(files.size(), false), seen_delay(files.size(), false);
  for (std::size_t s = 0; s < setups.size(); ++s) {
    const RatioFinding ratio = ratio_of(screening.span[s], screening.chosen_from * static_cast<double>(setups.size()));
    if (!ratio.known) continue;
    for (const std::size_t f : {setups[s].part, setups[s].assembly}) {
      const double to_mend = f == setups[s].part ? ratio.size : 1.0 / ratio.size;
      const bool small = std::abs(std::log(to_mend)) <= 0.02;
      if ((!small || ratio.deviations > significant) && !scaled[f]) {
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
  const double worst = misfit.span.empty() ? 1.0 : *std::ranges::max_element(misfit.span);
  bool any_active = false, any_imaginary = false, all_delayed = true;
  for (std::size_t f = 0; f < files.size(); ++f) {
    const bool active = misfit.active[f] > 0.0, imaginary = misfit.imaginary[f] > 1.0;
    any_active = any_active || active;
    any_imaginary = any_imaginary || imaginary;
    const PhaseTest& phase = screening.phase[f];
    all_delayed = all_delayed && is_delay(phase.delay, phase.delay_deviation);
    if (active || worst > large_misfit) {
      out.push_back(conjugate_trial(files, f));
      out.push_back(file_sign_trial(files, f));
    }
    if (active || is_delay(phase.delay, phase.delay_deviation)) out.push_back(delay_trial(files, f, phase.delay));
    if (imaginary || active || worst > large_misfit) {
      for (const int power : {-2, -1, 1, 2}) {
        if (is_a_quantity(files[f], power)) out.push_back(quantity_trial(files, f, power));
      }
    }
    const ReciprocityTest& mirror = screening.reciprocity[f];
    const double masses_tried = screening.chosen_from * static_cast<double>(files.size());
    if (mirror.mass > 0.0 && mirror.mass > 4.0 * mirror.mass_deviation && mirror.level > 0.01 &&
        !may_be_chance(mirror.mass / mirror.mass_deviation, mirror.mass_freedom, masses_tried)) {
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
  }
  if (any_active) out.push_back(for_all(files, [&](std::size_t f) { return conjugate_trial(files, f); }));
  if (any_active && all_delayed) {
    out.push_back(for_all(files, [&](std::size_t f) { return delay_trial(files, f, screening.phase[f].delay); }));
  }
  for (const int power : {-1, 1}) {
    const bool possible = std::ranges::all_of(files, [&](const CheckedFile& file) { return is_a_quantity(file, power); });
    if (any_imaginary && possible) out.push_back(for_all(files, [&](std::size_t f) { return quantity_trial(files, f, power); }));
  }
}

void add_exchanges(const Files& files, std::vector<MistakeTrial>& out) {
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
}

/// Whether some test leaves more than signs and labels may be to blame for; of files with covariances more than these explain.
bool is_large(const Files& files, const std::vector<SpanSetup>& setups, const Screening& screening, const Misfit& misfit) {
  constexpr double beyond = 1.5;  // of the noise
  const auto noise = [&](std::size_t f) { return files[f].errors ? screening.noise[f] : 0.0; };
  for (std::size_t s = 0; s < setups.size(); ++s) {
    const double known = setups[s].weighed ? 0.0 : std::hypot(noise(setups[s].part), noise(setups[s].assembly));
    if (misfit.span[s] > std::max(large_misfit, beyond * known)) return true;
  }
  for (std::size_t f = 0; f < files.size(); ++f) {
    if (misfit.reciprocity[f] > std::max(large_misfit, beyond * noise(f))) return true;
  }
  return false;
}

}  // namespace

std::size_t lines_for(const std::vector<SpanSetup>& setups, std::size_t most, double work) {
  double per_line = 1.0;
  for (const SpanSetup& setup : setups) {
    const std::size_t columns = setup.part_columns.size() + setup.outer_columns.size();
    const std::size_t per_column = setup.rows.size() * (setup.joint.size() + (setup.weighed ? 2 * setup.rows.size() : 0));
    per_line += static_cast<double>(columns * per_column);
  }
  return std::clamp<std::size_t>(static_cast<std::size_t>(work / per_line), 8, most);
}

std::string remedy_in(const std::string& file, const std::string& line) { return "[data.files.\"" + file + "\"]\n" + line; }

Screening screen(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups, std::size_t threads) {
  Screening out;
  out.span.resize(setups.size());
  for_each_index(setups.size(), threads, [&](std::size_t s) { out.span[s] = span_test(setups[s], files, SpanDetail::rows); });
  out.noise.assign(files.size(), unknown_noise);
  for (std::size_t s = 0; s < setups.size(); ++s) {
    if (out.span[s].lines == 0) continue;
    for (const std::size_t f : {setups[s].part, setups[s].assembly}) out.noise[f] = std::min(out.noise[f], out.span[s].level);
  }
  out.reciprocity.resize(files.size());
  out.phase.resize(files.size());
  for_each_index(files.size(), threads, [&](std::size_t f) {
    out.reciprocity[f] = reciprocity_test(files[f], true);
    out.phase[f] = phase_test(files[f], true);
    out.noise[f] = files[f].errors ? relative_error(files[f]) : out.noise[f] == unknown_noise ? usual_noise : out.noise[f];
    out.noise[f] = std::max(out.noise[f], 0.003);
  });
  return out;
}

std::vector<MistakeTrial> trials_of(const std::vector<CheckedFile>& files, const std::vector<SpanSetup>& setups,
                             const Screening& screening, const Misfit& misfit) {
  std::vector<MistakeTrial> out;
  const bool active = std::ranges::any_of(misfit.active, [](double a) { return a > 0.0; });
  if (active || is_large(files, setups, screening, misfit)) {
    add_channel_trials(files, candidate_channels(files, setups, screening), out);
    add_exchanges(files, out);
  }
  add_gain_trials(files, setups, screening, out);
  add_file_trials(files, setups, screening, misfit, out);
  return out;
}

UnitFactor nearest_unit(double measured, double tolerance) {
  for (const Mistaken& unit : mistaken_units) {
    if (std::abs(std::log(measured / unit.factor)) < tolerance) return {unit.factor, unit.words};
    if (std::abs(std::log(measured * unit.factor)) < tolerance) return {1.0 / unit.factor, std::string("the reverse of ") + unit.words};
  }
  return {measured, {}};
}

}  // namespace jointid::ident
