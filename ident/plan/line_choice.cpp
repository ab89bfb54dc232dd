#include "ident/plan/line_choice.hpp"

#include <cmath>

#include "base/error.hpp"
#include "weighting/line_selection.hpp"

namespace jointid::ident {
namespace {

/// Σ|H|² over the point FRFs of a system (the first reference's FRFs where it has none), line by line; NaN where one of them
/// was not measured. An FRF without any line counts nowhere.
std::vector<double> response_level(frf::FrfSystem& system) {
  const std::size_t lines = system.frequency_hz().size();
  std::vector<double> level(lines, 0.0), own(lines);
  const auto add = [&](const frf::Dof& response, const frf::Dof& reference) {
    frf::BlockReader reader(system, {response}, {reference});
    bool measured = false;
    for (std::size_t line = 0; line < lines; ++line) {
      Complex value;
      reader.read({&line, 1}, {&value, 1});
      own[line] = std::norm(value);
      measured = measured || std::isfinite(own[line]);
    }
    for (std::size_t line = 0; measured && line < lines; ++line) level[line] += own[line];
  };
  bool points = false;
  for (const frf::Dof& dof : system.responses()) {
    if (!frf::has(system.references(), dof)) continue;
    points = true;
    add(dof, dof);
  }
  for (const frf::Dof& dof : points ? Dofs() : system.responses()) add(dof, system.references().front());
  return level;
}

void exclude_resonances(const ResonanceExclusion& exclusion, frf::FrfSystem& system,
                        weighting::LineSelection& selection, std::vector<std::string>& notes) {
  const std::vector<double> resonances = weighting::find_resonances(system.frequency_hz(), response_level(system));
  for (const double frequency : resonances) {
    selection.exclude_hz.push_back(
        {frequency * (1.0 - exclusion.half_width), frequency * (1.0 + exclusion.half_width)});
  }
  notes.push_back("Found " + std::to_string(resonances.size()) + " resonances in the " + system.name() +
                  " and left out the lines around them.");
}

}  // namespace

std::vector<Line> choose_lines(const Scene& scene, frf::FrfSystem& substructures, frf::FrfSystem& assembly,
                               std::vector<std::string>& notes) {
  const FrequencySection& wanted = scene.frequency;
  weighting::LineSelection selection{
      .range_hz = wanted.range_hz, .step_hz = wanted.step_hz, .exclude_hz = wanted.exclude_hz};
  if (wanted.exclude_resonances) {
    if (wanted.exclude_resonances->of_substructures) {
      exclude_resonances(*wanted.exclude_resonances, substructures, selection, notes);
    }
    if (wanted.exclude_resonances->of_assembly) exclude_resonances(*wanted.exclude_resonances, assembly, selection, notes);
  }
  const std::vector<double>& axis = assembly.frequency_hz();
  const std::vector<std::size_t> partner = frf::match_lines(axis, substructures.frequency_hz());
  std::vector<Line> lines;
  std::size_t alone = 0;
  for (const std::size_t line : weighting::select_lines(axis, selection)) {
    if (partner[line] == frf::npos) {
      ++alone;
    } else {
      lines.push_back({axis[line], partner[line], line});
    }
  }
  if (alone > 0) {
    notes.push_back(std::to_string(alone) + " selected lines of the assembly have no partner in the substructures.");
  }
  if (lines.empty()) {
    throw InputError({.kind = alone > 0 ? ErrorKind::data : ErrorKind::usage,
                      .file = scene.file.string(),
                      .place = "[frequency]",
                      .problem = alone > 0 ? "no selected line is common to substructures and assembly"
                                           : "the selection leaves no line",
                      .remedy = "the assembly has " + frf::range_text(assembly.frequency_hz()) + ", the substructures " +
                                frf::range_text(substructures.frequency_hz())});
  }
  return lines;
}

}  // namespace jointid::ident
