#include "problems/in_memory.hpp"

namespace jointid::problems {
namespace {

std::unique_ptr<frf::FrfSystem> system(const char* name, std::vector<frf::FrfSet> sets, frf::Composition composition) {
  std::vector<std::unique_ptr<frf::FrfSource>> sources;
  for (frf::FrfSet& set : sets) sources.push_back(frf::from_memory(std::move(set)));
  return std::make_unique<frf::FrfSystem>(name, std::move(sources), composition, false);
}

}  // namespace

ident::Scene scene(const Problem& problem) { return ident::parse_scene(problem.scene, problem.name + ".toml"); }

std::unique_ptr<ident::Plan> plan(const ident::Scene& scene, Measurement measurement) {
  std::vector<frf::FrfSet> assembly;
  assembly.push_back(std::move(measurement.assembly));
  return ident::make_plan(scene, system("substructures", std::move(measurement.substructures), frf::Composition::uncoupled),
                          system("assembly", std::move(assembly), frf::Composition::merged));
}

}  // namespace jointid::problems
