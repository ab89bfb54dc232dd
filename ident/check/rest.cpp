#include "ident/check/rest.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/eigen.hpp"
#include "base/statistics.hpp"
#include "base/text.hpp"
#include "frf/noise/variance_law.hpp"
#include "ident/check/agreement.hpp"
#include "ident/check/dropouts.hpp"
#include "ident/check/test/misfit.hpp"
#include "ident/check/test/reference_groups.hpp"
#include "ident/check/trial/mistake_trial.hpp"

namespace jointid::ident {
namespace {

using Files = std::vector<CheckedFile>;
using Eigen::Index;

constexpr double unexplained_confidence = 0.6, one_number_confidence = 0.75;

/// The lines, an eighth of all, whose χ² is furthest beyond its expectation.
std::string band_of(const Agreement& test) {
  std::vector<Line> lines;
  for (const double hz : test.frequency_hz) lines.push_back({.frequency_hz = hz});
  return worst_band(lines, test.by_line);
}

/// The row and column whose cells are largest on average.
struct WorstPlaces {
  frf::Dof row, column;
};

WorstPlaces worst_places(const Agreement& test) {
  const auto mean = [](const auto& cells) {
    double sum = 0.0, count = 0.0;
    for (const double cell : cells) {
      if (!std::isfinite(cell)) continue;
      sum += cell;
      count += 1.0;
    }
    return count > 0.0 ? sum / count : 0.0;
  };
  WorstPlaces out;
  double most = -1.0;
  for (Index r = 0; r < test.cells.rows(); ++r) {
    if (const double own = mean(test.cells.row(r)); own > most) {
      most = own;
      out.row = test.rows[static_cast<std::size_t>(r)];
    }
  }
  most = -1.0;
  for (Index c = 0; c < test.cells.cols(); ++c) {
    if (const double own = mean(test.cells.col(c)); own > most) {
      most = own;
      out.column = test.columns[static_cast<std::size_t>(c)];
    }
  }
  return out;
}

std::string value_text(const CheckedFile& file, const frf::Dof& response, const frf::Dof& reference, std::size_t line) {
  const Complex value = file.frfs[line](at(place_of(file.responses, response)), at(place_of(file.references, reference)));
  const Complex stored = value / std::sqrt(std::max(frf::squared_factor(file.quantity, file.frequency_hz[line]), 1e-300));
  return fmt::format("{:.4g}", std::abs(stored));
}

Suspect one_number(const CheckedFile& file, const frf::Dof& response, const frf::Dof& reference, std::size_t line, double ratio) {
  return {.kind = SuspectKind::outlier,
          .file = file.name,
          .dofs = {response, reference},
          .evidence =
              fmt::format("one number: the {} of {} over {} at {:g} Hz has the size {}, {:.2g} times its standard error off what "
                          "the other FRFs and lines make of it",
                          frf::name(file.quantity), response.name(), reference.name(), file.frequency_hz[line],
                          value_text(file, response, reference, line), std::sqrt(ratio)),
          .confidence = one_number_confidence,
          .remedy = fmt::format("[frequency]\nexclude = [[{0:g}, {0:g}]]", file.frequency_hz[line])};
}

/// Of a pair, the FRF that jumps.
Suspect one_number_of_pair(const CheckedFile& file, const Agreement& test) {
  frf::Dof i = test.rows[static_cast<std::size_t>(test.worst_row)], j = test.columns[static_cast<std::size_t>(test.worst_column)];
  if (jump(file, j, i, test.worst_line) > jump(file, i, j, test.worst_line)) std::swap(i, j);
  return one_number(file, i, j, test.worst_line, test.worst_ratio);
}

/// "mostly in the references …": a group, one coordinate, or the worst pair.
std::string where_not_reciprocal(const CheckedFile& file, const Agreement& test, Dofs& group) {
  for (const std::size_t k : group_that_differs(test.cells)) group.push_back(test.rows[k]);
  if (group.size() == 1)
    return "mostly in those of " + group.front().name() + ": look for hits beside the point, or a sensor on its side";
  if (!group.empty()) {
    return "mostly in references " + group_text(group) +
           " against the others. Each of the two groups agrees within itself: between them the structure changed (bolts, "
           "temperature, "
           "force level, another day), or points were renumbered";
  }
  Index i = 0, j = 0;
  test.cells.unaryExpr([](double cell) { return std::isfinite(cell) ? cell : 0.0; }).maxCoeff(&i, &j);
  group = {test.rows[static_cast<std::size_t>(i)], test.columns[static_cast<std::size_t>(j)]};
  return "most between " + group[0].name() + " and " + group[1].name() + ", in " + file.name + band_of(test);
}

/// By how much the noise of a file is larger than it says, where H_ij − H_ji is noise that most lines and pairs agree on; else 1.
double noise_beyond_records(const CheckedFile& file, const Agreement& test) {
  constexpr double just_noise = 2.0;
  if (!test.recorded || !(test.ratio > 1.0) || !group_that_differs(test.cells).empty()) return 1.0;
  const Agreement own = mirror_agreement(file, false);
  return own.freedom > 0.0 && own.ratio < just_noise ? test.ratio : 1.0;
}

std::optional<Suspect> not_reciprocal(const CheckedFile& file, const Agreement& test, const ReciprocityTest& screened,
                                      double noise) {
  const bool by_much = screened.level > std::max(0.3, 4.0 * noise);
  const bool contradicts = test.contradicts() && noise_beyond_records(file, test) == 1.0;
  if (!contradicts && !by_much) return std::nullopt;
  if (is_one_number(test)) return one_number_of_pair(file, test);
  const double rms = reciprocity_map(file).overall;
  Dofs group;
  std::string evidence = "H_ij and H_ji differ by " + percent(rms) + " rms (" + percent(screened.level) + " at most lines), ";
  evidence += contradicts ? digits(std::sqrt(test.ratio)) + " times what noise makes of it, "
                          : "where the noise is about " + percent(noise) + ", ";
  if (test.freedom > 0.0) evidence += where_not_reciprocal(file, test, group);
  return Suspect{.kind = SuspectKind::not_reciprocal,
                 .file = file.name,
                 .dofs = group,
                 .evidence = evidence,
                 .confidence = unexplained_confidence,
                 .remedy = ""};
}

/// One FRF with a gain of its own: of the two of a pair, it cannot be told which.
std::optional<Suspect> gain_of_one_frf(const CheckedFile& file, double tried) {
  const auto found = factor_of_one_pair(file, tried);
  if (!found) return std::nullopt;
  return Suspect{.kind = SuspectKind::gain,
                 .file = file.name,
                 .dofs = {found->i, found->j},
                 .evidence = fmt::format(
                     "one FRF: that of {0} over {1} is {2:.3g} ± {3:.1g} times that of {1} over {0}, where the middle one "
                     "of all pairs is off by {4}. One of the two is wrong: its gain, range or hits",
                     found->i.name(), found->j.name(), found->factor, found->deviation, percent(found->usual)),
                 .confidence = unexplained_confidence,
                 .remedy = ""};
}

/// Of the span tests the one that is furthest beyond its noise.
struct WorstSpan {
  Agreement test;
  const SpanSetup* setup = nullptr;
};

/// `mirror` of each file, `span` of each setup.
WorstSpan worst_span(const Files& files, const std::vector<SpanSetup>& setups, const std::vector<Agreement>& mirror,
                     std::vector<Agreement> span) {
  WorstSpan worst;
  std::vector<double> beyond;
  for (std::size_t f = 0; f < files.size(); ++f) beyond.push_back(noise_beyond_records(files[f], mirror[f]));
  for (std::size_t s = 0; s < setups.size(); ++s) {
    const SpanSetup& setup = setups[s];
    Agreement& test = span[s];
    test.ratio /= std::max(beyond[setup.part], beyond[setup.assembly]);
    if (!test.contradicts() || (worst.setup != nullptr && test.ratio <= worst.test.ratio)) continue;
    worst = {std::move(test), &setup};
  }
  return worst;
}

Suspect not_of_the_parts(const Files& files, const WorstSpan& worst) {
  const CheckedFile &assembly = files[worst.setup->assembly], &part = files[worst.setup->part];
  const Agreement& test = worst.test;
  const bool turned = worst.setup->transposed;
  const auto named = [&](frf::Dof row, frf::Dof column) { return turned ? Dofs{column, row} : Dofs{row, column}; };
  if (is_one_number(test)) {
    const Dofs dofs =
        named(test.rows[static_cast<std::size_t>(test.worst_row)], test.columns[static_cast<std::size_t>(test.worst_column)]);
    const bool in_part = jump(part, dofs[0], dofs[1], test.worst_line) > jump(assembly, dofs[0], dofs[1], test.worst_line);
    return one_number(in_part ? part : assembly, dofs[0], dofs[1], test.worst_line, test.worst_ratio);
  }
  const WorstPlaces places = worst_places(test);
  const Dofs dofs = named(places.row, places.column);
  return {.kind = SuspectKind::nonlinear,
          .file = assembly.name,
          .dofs = dofs,
          .evidence = "the FRFs of " + assembly.name + " do not follow from those of " + part.name +
                      " by forces at the joint, whatever it is. They are off by " + digits(std::sqrt(test.ratio)) +
                      " times what noise makes of it (χ² over degrees of freedom " + digits(test.ratio, "%.3g") +
                      "), most in the response " + dofs[0].name() + " and the reference " + dofs[1].name() + band_of(test) +
                      ". Parts that changed between the tests (temperature, supports, bolts) do that, and a joint DOF left out",
          .confidence = unexplained_confidence,
          .remedy = ""};
}

/// All FRFs of an assembly, or of a part, off by a factor.
std::vector<Suspect> small_gains(const Files& files, const std::vector<SpanSetup>& setups, const std::vector<Agreement>& span,
                                 double chosen_from) {
  const double tried = chosen_from * static_cast<double>(setups.size());
  std::vector<Suspect> found;
  for (std::size_t a = 0; a < files.size(); ++a) {
    std::vector<std::pair<const SpanSetup*, const Agreement*>> tests;
    for (std::size_t s = 0; s < setups.size(); ++s) {
      if (setups[s].assembly == a && !setups[s].transposed) tests.emplace_back(&setups[s], &span[s]);
    }
    const auto tells = [&](const auto& test) { return test.second->tells_gain(tried); };
    const auto first = std::ranges::find_if(tests, tells);
    if (first == tests.end()) continue;
    const double excess = first->second->excess;
    const bool of_all = std::ranges::all_of(tests, [&](const auto& test) {
      return std::abs(test.second->excess - excess) <
             0.3 * std::abs(excess) + 4.0 * std::hypot(test.second->excess_deviation, first->second->excess_deviation);
    });
    const CheckedFile& file = files[of_all ? a : first->first->part];
    const double factor = of_all ? 1.0 + excess : 1.0 / (1.0 + excess);
    found.push_back(
        {.kind = SuspectKind::gain,
         .file = file.name,
         .dofs = {},
         .evidence = fmt::format("all FRFs of the file are off by the factor {:.4g} ± {:.2g}, by substructures and joint forces; "
                                 "calibrations leave a few tenths of a percent",
                                 1.0 / factor, first->second->excess_deviation),
         .confidence = 0.7,
         .remedy = remedy_in(file.name, fmt::format("gain = {:.5g}", factor))});
  }
  return found;
}

Suspect not_passive(const CheckedFile& file) {
  return {.kind = SuspectKind::not_passive,
          .file = file.name,
          .dofs = {},
          .evidence = "the imaginary parts of driving points are positive: the structure is not passive",
          .confidence = unexplained_confidence,
          .remedy = ""};
}

void add_nonlinear(const Screening& screening, std::vector<Suspect>& found) {
  double worst = 0.0, mirror = 0.02;
  for (const SpanTest& span : screening.span) worst = std::max(worst, span.level);
  for (const ReciprocityTest& test : screening.reciprocity) mirror = std::max(mirror, test.level);
  if (!(worst > 0.35 && worst > 4.0 * mirror)) return;
  found.push_back(
      {.kind = SuspectKind::nonlinear,
       .file = "",
       .dofs = {},
       .evidence =
           "forces at the joint's coordinates leave " + percent(worst) +
           " of the assembly's FRFs, where H_ij and H_ji agree to " + percent(mirror) +
           ". Parts and assembly are not the same structures, the joint acts at other coordinates too, or it is not linear",
       .confidence = 0.5,
       .remedy = ""});
}

}  // namespace

std::string worst_band(const std::vector<Line>& lines, const std::vector<double>& by_line) {
  const std::size_t n = std::min(lines.size(), by_line.size()), width = std::max<std::size_t>(1, n / 8);
  double most = 0.0;
  std::size_t first = n;
  for (std::size_t k = 0; k + width <= n; ++k) {
    double sum = 0.0;
    for (std::size_t i = k; i < k + width; ++i) sum += std::isnan(by_line[i]) ? 0.0 : by_line[i];
    if (sum > most) {
      most = sum;
      first = k;
    }
  }
  if (first == n) return "";
  return ", most from " + digits(lines[first].frequency_hz, "%.4g") + " to " +
         digits(lines[first + width - 1].frequency_hz, "%.4g") + " Hz";
}

std::vector<Suspect> unexplained(const Files& files, const std::vector<SpanSetup>& setups, const Screening& screening,
                                 const std::vector<double>& noise, bool names_lines) {
  std::vector<Suspect> found;
  std::vector<Agreement> mirror, span;
  Dropouts dropouts(files);
  for (std::size_t f = 0; f < files.size(); ++f) mirror.push_back(dropouts.take_out(f, mirror_agreement(files[f])));
  for (std::size_t f = 0; f < files.size(); ++f) {
    if (activity(files[f], noise[f]) > 1.5) found.push_back(not_passive(files[f]));
    if (auto suspect = not_reciprocal(files[f], mirror[f], screening.reciprocity[f], noise[f]))
      found.push_back(std::move(*suspect));
  }
  for (std::size_t f = 0; f < files.size() && found.empty(); ++f) {
    if (auto suspect = gain_of_one_frf(files[f], screening.chosen_from * static_cast<double>(files.size())))
      found.push_back(std::move(*suspect));
  }
  const bool one = std::ranges::any_of(found, [](const Suspect& suspect) { return suspect.kind == SuspectKind::outlier; });
  if (!one) {
    for (const SpanSetup& setup : setups) span.push_back(dropouts.take_out(setup, span_agreement(setup, files)));
  }
  if (names_lines) {
    for (Suspect& lines : dropouts.suspects()) found.push_back(std::move(lines));
  }
  if (found.empty() && dropouts.empty()) {
    for (Suspect& gain : small_gains(files, setups, span, screening.chosen_from)) found.push_back(std::move(gain));
  }
  const WorstSpan worst = one ? WorstSpan{} : worst_span(files, setups, mirror, std::move(span));
  if (worst.setup != nullptr) {
    found.push_back(not_of_the_parts(files, worst));
  } else if (!one) {
    add_nonlinear(screening, found);
  }
  return found;
}

std::vector<std::string> missing_points(const Files& files, const Dofs& joint) {
  std::vector<std::string> notes;
  for (const CheckedFile& file : files) {
    if (file.assembly) continue;
    Dofs missing;
    for (const frf::Dof& dof : joint) {
      const std::size_t r = place_of(file.responses, dof), c = place_of(file.references, dof);
      if (r == frf::npos && c == frf::npos) continue;
      const bool there = r != frf::npos && c != frf::npos && std::ranges::any_of(file.frfs, [&](const Eigen::MatrixXcd& line) {
                           return std::isfinite(std::norm(line(at(r), at(c))));
                         });
      if (!there) missing.push_back(dof);
    }
    if (missing.empty()) continue;
    notes.push_back(file.name + " has no driving point FRF of the joint's " +
                    comma_list(missing, [](const frf::Dof& dof) { return dof.name(); }) +
                    ": what forces there do to the part is not measured, and cannot be checked");
  }
  return notes;
}

}  // namespace jointid::ident
