#include <algorithm>
#include <array>
#include <charconv>

#include "base/text.hpp"
#include "problems/case/case.hpp"

namespace jointid::problems {
namespace {

/// Shortest decimal that reads back as the same double, always a TOML float.
std::string number(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  std::string text(buffer.data(), end);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

template <class Range, class Text>
std::string array(const Range& range, Text text) {
  return "[" + comma_list(range, text) + "]";
}

std::string array(const Matrix& matrix) {
  return array(matrix, [](const std::vector<double>& row) { return array(row, number); });
}

std::string entry_text(const restrictions::Entry& entry) {
  const auto* value = std::get_if<double>(&entry);
  return value ? number(*value) : quoted(std::get<std::string>(entry));
}

std::string spring_text(const restrictions::Spring& spring) {
  return "[" + quoted(spring.first.name()) + ", " + quoted(spring.second ? spring.second->name() : "ground") + "]";
}

/// Cases declare symmetric patterns, entries and springs only.
std::string declaration(const restrictions::MatrixSpec& spec) {
  if (const auto* springs = std::get_if<std::vector<restrictions::Spring>>(&spec)) return "springs = " + array(*springs, spring_text);
  const auto* entries = std::get_if<restrictions::EntryMatrix>(&spec);
  if (entries == nullptr) return "pattern = \"symmetric\"";
  return "matrix = " + array(*entries, [](const auto& row) { return array(row, entry_text); });
}

using Interval = std::array<double, 2>;

/// Intervals within ±1 % of the natural frequencies of parts and assembly that reach into the axis, united
/// where they overlap.
std::vector<Interval> resonance_intervals(const Case& definition, const Problem& problem) {
  const std::vector<double> axis = frequencies(definition.axis);
  std::vector<Interval> found;
  const auto collect = [&](const Modes& all) {
    for (const double f : all.frequency_hz) {
      const Interval interval = {0.99 * f, 1.01 * f};
      if (interval[1] >= axis.front() && interval[0] <= axis.back()) found.push_back(interval);
    }
  };
  for (const Modes& part : problem.substructure_modes) collect(part);
  collect(problem.assembly_modes);
  std::sort(found.begin(), found.end());
  std::vector<Interval> united;
  for (const Interval& interval : found) {
    if (!united.empty() && interval[0] <= united.back()[1]) {
      united.back()[1] = std::max(united.back()[1], interval[1]);
    } else {
      united.push_back(interval);
    }
  }
  return united;
}

std::string data_text(const Problem& problem) {
  const auto file = [](const frf::FrfSet& set) { return quoted(set.header.file); };
  return "[data]\nsubstructures = " + array(problem.substructures, file) + "\nassembly = [" +
         file(problem.assembly) + "]\n";
}

std::string frequency_text(const Case& definition, const Problem& problem) {
  const std::vector<double> axis = frequencies(definition.axis);
  std::string text =
      "[frequency]\nrange = [" + number(axis.front()) + ", " + number(axis.back()) + "]  # Hz\n";
  if (definition.exclude_resonances) {
    text += "# within 1 % of the natural frequencies of parts and assembly\nexclude = " +
            array(resonance_intervals(definition, problem),
                  [](const Interval& interval) { return array(interval, number); }) +
            "\n";
  }
  return text;
}

std::string joint_text(const Case& definition) {
  std::string text = "[joint]\ndofs = " +
                     array(definition.joint_dofs, [](const frf::Dof& dof) { return quoted(dof.name()); }) +
                     "\n";
  for (const JointMatrix& matrix : definition.joint) {
    text += "\n[joint." + restrictions::key(matrix.kind) + "]\n" + declaration(matrix.spec) + "\n";
  }
  return text;
}

std::string identify_text(const Case& definition) {
  std::string text = "[identify]\nmethod = " + quoted(definition.method) + "\n";
  if (!definition.equations.empty()) text += "equations = " + array(definition.equations, quoted) + "\n";
  if (!definition.weighting.empty()) text += "weighting = " + quoted(definition.weighting) + "\n";
  if (definition.delta > 0.0) text += "delta = " + number(definition.delta) + "\n";
  if (definition.start_stiffness) {
    text += "start = { stiffness = " + array(*definition.start_stiffness) +
            (definition.start_damping ? ", hysteretic_damping = " + array(*definition.start_damping) : "") + " }\n";
  }
  return text;
}

/// A hammer test says itself what its noise is, by the coherence in the data.
std::string noise_text(const ProblemNoise& noise) {
  if (const auto* modal = std::get_if<ConsistentErrors>(&noise)) {
    return "[noise]\nmodel = \"modal\"\nlevel = " + number(modal->shape) + "\n\n";
  }
  const auto& model = std::get<frf::NoiseModel>(noise);
  if (model.kind == frf::NoiseKind::hammer) return {};
  return "[noise]\nmodel = " + quoted(frf::name(model.kind)) + "\nlevel = " + number(model.level) + "\n" +
         (model.floor > 0.0 ? "floor = " + number(model.floor) + "\n" : "") + "\n";
}

std::string truth_section(const Problem& problem) {
  std::string text = "[truth]\n";
  for (const auto& [kind, matrix] : problem.truth)
    text += restrictions::key(kind) + " = " + array(matrix) + "\n";
  return text;
}

}  // namespace

std::string scene_text(const Case& definition, const Problem& problem) {
  return "title = " + quoted(definition.name + ": " + definition.description) + "\n\n" + data_text(problem) +
         "\n" + frequency_text(definition, problem) + "\n" + joint_text(definition) + "\n" +
         identify_text(definition) + "\n" + noise_text(definition.noise) + truth_section(problem);
}

}  // namespace jointid::problems
