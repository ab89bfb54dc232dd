#include "ident/line_choice.hpp"

#include <cmath>
#include <numeric>

#include "frf/error.hpp"
#include "weighting/line_selection.hpp"

namespace jointid::ident {
namespace {

/// Σ|H|² over the point FRFs of a system (the first reference's FRFs where it has none), line by line.
std::vector<double> response_level(frf::FrfSystem& system) {
  Dofs points;
  for (const frf::Dof& dof : system.responses()) {
    if (frf::find_coordinate(system.references(), dof) != frf::npos) points.push_back(dof);
  }
  std::vector<double> level(system.frequency_hz().size(), 0.0);
  const auto add = [&](const Dofs& rows, const Dofs& columns) {
    frf::BlockReader reader(system, rows, columns);
    std::vector<frf::Complex> values(rows.size() * columns.size());
    for (std::size_t line = 0; line < level.size(); ++line) {
      reader.read({&line, 1}, values);
      for (const frf::Complex& value : values) level[line] += std::isfinite(std::norm(value)) ? std::norm(value) : 0.0;
    }
  };
  for (const frf::Dof& point : points) add({point}, {point});
  if (points.empty()) add(system.responses(), {system.references().front()});
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
    const auto range = [](const frf::FrfSystem& system) {
      return std::to_string(system.frequency_hz().front()) + " to " + std::to_string(system.frequency_hz().back()) +
             " Hz in " + std::to_string(system.frequency_hz().size()) + " lines";
    };
    throw InputError({.kind = alone > 0 ? ErrorKind::data : ErrorKind::usage,
                      .file = scene.file.string(),
                      .place = "[frequency]",
                      .problem = alone > 0 ? "no selected line is common to substructures and assembly"
                                           : "the selection leaves no line",
                      .remedy = "the assembly has " + range(assembly) + ", the substructures " + range(substructures)});
  }
  return lines;
}

}  // namespace jointid::ident
