#include "problems/case/in_memory.hpp"

#include <numeric>

#include "frf/set/frf_source.hpp"
#include "ident/identify.hpp"
#include "ident/scene/read_scene.hpp"

namespace jointid::problems {
namespace {

std::shared_ptr<frf::FrfSystem> parts_of(Measurement& measurement) {
  return frf::memory_system("substructures", std::move(measurement.substructures), frf::Composition::uncoupled);
}

std::shared_ptr<frf::FrfSystem> assembly_of(Measurement& measurement) {
  std::vector<frf::FrfSet> assembly;
  assembly.push_back(std::move(measurement.assembly));
  return frf::memory_system("assembly", std::move(assembly), frf::Composition::merged);
}

}  // namespace

frf::FrfSet without(const frf::FrfSet& set, const std::vector<frf::Dof>& coordinates) {
  const auto kept = [&coordinates](const std::vector<frf::Dof>& dofs) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < dofs.size(); ++i) {
      if (frf::find_coordinate(coordinates, dofs[i]) == frf::npos) places.push_back(i);
    }
    return places;
  };
  std::vector<std::size_t> lines(set.header.lines());
  std::iota(lines.begin(), lines.end(), std::size_t{0});
  return frf::load(*frf::from_memory(set), {lines, kept(set.header.response), kept(set.header.reference)});
}

ident::Scene scene(const Problem& problem) { return ident::parse_scene(problem.scene, problem.name + ".toml"); }

std::unique_ptr<ident::Plan> plan(const ident::Scene& scene, Measurement measurement) {
  return ident::make_plan(scene, parts_of(measurement), assembly_of(measurement));
}

ident::CheckResult check(const ident::Scene& scene, Measurement measurement) {
  return ident::check_systems(scene, parts_of(measurement), assembly_of(measurement));
}

std::shared_ptr<const study::TrialData> trial_data(const ident::Scene& scene, const Problem& problem) {
  const study::Measurements clean{problem.substructures, {problem.assembly}};
  if (const auto* model = std::get_if<frf::NoiseModel>(&problem.noise)) {
    return study::make_trial_data(scene, clean, *model);
  }
  const auto regenerate = [errors = std::get<ConsistentErrors>(problem.noise), parts = problem.substructure_modes,
                           whole = problem.assembly_modes](std::uint64_t seed, std::uint64_t trial,
                                                           study::Measurements& data) {
    for (std::size_t i = 0; i < parts.size(); ++i) {
      data.substructures[i] = with_modal_errors(data.substructures[i], parts[i], errors, {seed, trial, i});
    }
    data.assembly.front() = with_modal_errors(data.assembly.front(), whole, errors, {seed, trial, parts.size()});
  };
  return study::make_trial_data(scene, clean, regenerate);
}

}  // namespace jointid::problems
