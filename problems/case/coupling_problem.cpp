#include "problems/case/coupling_problem.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/temporary_file.hpp"
#include "problems/case/coupling_cases.hpp"
#include "problems/case/set_format.hpp"

namespace jointid::problems {
namespace {

frf::FrfSet clean_set(const Structure& structure, const std::vector<frf::Dof>& dofs, const Axis& axis, const std::string& file) {
  frf::FrfSet set = frequency_response(structure, {.response = dofs, .reference = dofs, .frequency_hz = frequencies(axis)});
  set.header.file = file;
  return set;
}

/// The structure without a DOF, which is held in place.
Structure grounded(const Structure& structure, const frf::Dof& held) {
  std::vector<frf::Dof> dofs = structure.dofs();
  const std::size_t gone = structure.index(held), n = structure.size();
  dofs.erase(dofs.begin() + static_cast<std::ptrdiff_t>(gone));
  Structure result(structure.nodes(), dofs);
  for (const Kind kind : restrictions::all_kinds) {
    Matrix rest;
    for (std::size_t i = 0; i < n; ++i) {
      if (i == gone) continue;
      rest.emplace_back();
      for (std::size_t j = 0; j < n; ++j) {
        if (j != gone) rest.back().push_back(structure.matrix(kind)[i * n + j]);
      }
    }
    result.add(kind, dofs, rest);
  }
  return result;
}

/// All parts side by side with x_i = x_j and x = 0 put into K, M, C and D: nothing of receptances.
Structure assembled(const CouplingCase& definition) {
  Structure result = definition.parts.front();
  for (std::size_t i = 1; i < definition.parts.size(); ++i) result = merged(result, definition.parts[i]);
  std::vector<int> stands_for(100);
  for (std::size_t i = 0; i < stands_for.size(); ++i) stands_for[i] = static_cast<int>(i);
  for (const auto& [first, second] : definition.join) {
    const auto [kept, gone] = std::minmax(stands_for[static_cast<std::size_t>(first)], stands_for[static_cast<std::size_t>(second)]);
    result = tied(result, coordinate(kept), coordinate(gone));
    std::ranges::replace(stands_for, int{gone}, int{kept});
  }
  for (const int number : definition.ground) result = grounded(result, coordinate(stands_for[static_cast<std::size_t>(number)]));
  return result;
}

std::string scene_text(const CouplingCase& definition, const CouplingProblem& problem) {
  std::string parts, join, ground;
  for (const frf::FrfSet& part : problem.parts) parts += (parts.empty() ? "\"" : ", \"") + part.header.file + "\"";
  for (const auto& [a, b] : problem.join) join += (join.empty() ? "[\"" : ", [\"") + a.name() + "\", \"" + b.name() + "\"]";
  for (const frf::Dof& dof : problem.ground) ground += (ground.empty() ? "\"" : ", \"") + dof.name() + "\"";
  std::string text = "title = \"" + problem.name + ": " + problem.description + "\"\n\n[data]\nparts = [" + parts +
                     "]\n\n[couple]\njoin = [" + join + "]\n";
  if (!ground.empty()) text += "ground = [" + ground + "]\n";
  return text + definition.couple;
}

CouplingProblem build(const CouplingCase& definition) {
  CouplingProblem problem;
  problem.name = definition.name;
  problem.description = definition.description;
  problem.noise = definition.noise;
  for (const auto& [a, b] : definition.join) problem.join.push_back({coordinate(a), coordinate(b)});
  for (const int number : definition.ground) problem.ground.push_back(coordinate(number));
  for (const Structure& part : definition.parts) {
    const std::string file = definition.name + "_part_" + std::to_string(problem.parts.size() + 1) + ".h5";
    problem.parts.push_back(clean_set(part, part.dofs(), definition.axis, file));
    problem.part_modes.push_back(modes(part));
  }
  const Structure whole = assembled(definition);
  problem.assembly = clean_set(whole, whole.dofs(), definition.axis, definition.name + "_assembly.h5");
  problem.assembly_modes = modes(whole);
  problem.scene = scene_text(definition, problem);
  return problem;
}

std::string truth_text(const CouplingProblem& problem) {
  nlohmann::ordered_json truth = {{"name", problem.name}, {"description", problem.description}};
  auto& frequencies = truth["natural_frequencies_hz"];
  for (const Modes& part : problem.part_modes) frequencies["parts"].push_back(part.frequency_hz);
  frequencies["assembly"] = problem.assembly_modes.frequency_hz;
  return truth.dump(1) + "\n";
}

}  // namespace

coupling::Assembly CouplingProblem::declared() const {
  coupling::Assembly out;
  for (const auto& [a, b] : join) out.join.push_back({{{}, a}, {{}, b}});
  for (const frf::Dof& dof : ground) out.ground.push_back({{}, dof});
  return out;
}

std::vector<ProblemInfo> list_coupling() {
  std::vector<ProblemInfo> out;
  for (const CouplingCase& definition : all_coupling_cases()) out.push_back({definition.name, definition.description});
  return out;
}

bool is_coupling(const std::string& name) {
  return std::ranges::any_of(list_coupling(), [&](const ProblemInfo& info) { return info.name == name; });
}

CouplingProblem make_coupling(const std::string& name) {
  std::vector<std::string> names;
  for (const CouplingCase& definition : all_coupling_cases()) {
    if (definition.name == name) return build(definition);
    names.push_back(definition.name);
  }
  refuse_problem("there is no coupling problem '" + name + "'", name, names);
}

std::vector<frf::FrfSet> polluted(const CouplingProblem& problem, std::uint64_t seed, std::uint64_t trial) {
  std::vector<frf::FrfSet> out;
  for (std::size_t i = 0; i < problem.parts.size(); ++i) {
    out.push_back(with_noise(problem.parts[i], problem.part_modes[i], problem.noise, {seed, trial, i}));
  }
  return out;
}

std::vector<coupling::Part> parts_of(const CouplingProblem& problem, const std::vector<frf::FrfSet>& sets) {
  std::vector<coupling::Part> out;
  for (std::size_t i = 0; i < sets.size(); ++i) {
    std::vector<std::unique_ptr<frf::FrfSource>> source;
    source.push_back(frf::from_memory(sets[i]));
    const std::string& name = problem.parts[i].header.file;
    out.push_back({name, std::make_shared<frf::FrfSystem>(name, std::move(source), frf::Composition::merged, false)});
  }
  return out;
}

std::filesystem::path write(const CouplingProblem& problem, const std::filesystem::path& directory, const WriteOptions& options) {
  const SetFormat& format = find_set_format(options.format);
  const std::vector<frf::FrfSet> parts = options.clean ? problem.parts : polluted(problem, options.seed, 0);
  std::error_code ignored;  // a folder that cannot be made shows when the first file is written
  std::filesystem::create_directories(directory, ignored);
  std::string scene_text = problem.scene;
  const auto write_set = [&](const frf::FrfSet& set) {
    const std::string file = std::filesystem::path(set.header.file).replace_extension(format.name).string();
    format.write(set, directory / file);
    const std::size_t at = scene_text.find(set.header.file);
    if (at != std::string::npos) scene_text.replace(at, set.header.file.size(), file);
  };
  for (const frf::FrfSet& part : parts) write_set(part);
  write_set(problem.assembly);
  write_text(directory / "truth.json", truth_text(problem));
  const std::filesystem::path scene = directory / (problem.name + ".toml");
  write_text(scene, scene_text);
  return scene;
}

}  // namespace jointid::problems
