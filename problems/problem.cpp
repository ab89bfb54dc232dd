#include "problems/problem.hpp"

#include "base/error.hpp"
#include "problems/catalogue.hpp"
#include "problems/coupling_problem.hpp"
#include "problems/modal_set.hpp"
#include "problems/rig_two.hpp"

namespace jointid::problems {
namespace {

void append(std::vector<Case>& all, std::vector<Case> more) {
  for (Case& definition : more) all.push_back(std::move(definition));
}

}  // namespace

frf::FrfSet with_noise(const frf::FrfSet& clean, const Modes& exact, const ProblemNoise& noise,
                       const RandomStream& stream) {
  if (const auto* errors = std::get_if<ConsistentErrors>(&noise))
    return with_modal_errors(clean, exact, *errors, stream);
  return frf::polluted(clean, std::get<frf::NoiseModel>(noise), stream.seed, stream.trial, stream.set);
}

std::vector<Case> all_cases() {
  std::vector<Case> all = cases_of_basic_study();
  append(all, cases_of_refined_weighting());
  append(all, cases_of_accuracy());
  append(all, cases_of_hard_joints());
  append(all, cases_of_other_data());
  append(all, cases_of_rig_one());
  append(all, cases_of_bolts());
  return all;
}

std::vector<ProblemInfo> list() {
  std::vector<ProblemInfo> result;
  for (const Case& definition : all_cases()) result.push_back({definition.name, definition.description});
  return result;
}

Problem make(const std::string& name) {
  std::vector<std::string> names;
  for (const Case& definition : all_cases()) {
    if (definition.name == name) return build(definition);
    names.push_back(definition.name);
  }
  for (const ProblemInfo& info : list_coupling()) names.push_back(info.name);
  for (const ProblemInfo& info : list_rig_two()) names.push_back(info.name);
  for (const ProblemInfo& info : list_modal_sets()) names.push_back(info.name);
  const std::string near = nearest_word(name, names);
  throw InputError(
      {.kind = ErrorKind::usage,
       .file = {},
       .place = "problem",
       .problem = "there is no problem '" + name + "'",
       .remedy = near.empty() ? "list the problems to see their names" : "did you mean " + near + "?"});
}

Measurement polluted(const Problem& problem, std::uint64_t seed, std::uint64_t trial) {
  Measurement result;
  const std::size_t parts = problem.substructures.size();
  for (std::size_t i = 0; i < parts; ++i) {
    result.substructures.push_back(
        with_noise(problem.substructures[i], problem.substructure_modes[i], problem.noise, {seed, trial, i}));
  }
  result.assembly = with_noise(problem.assembly, problem.assembly_modes, problem.noise, {seed, trial, parts});
  return result;
}

}  // namespace jointid::problems
