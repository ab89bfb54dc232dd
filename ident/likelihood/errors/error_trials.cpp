#include "ident/likelihood/errors/error_trials.hpp"

#include "ident/likelihood/data/likelihood_plan.hpp"
#include "ident/scene/variance_origin.hpp"

namespace jointid::ident {
namespace {

const SystematicUnknown unit_gain{Systematic::gain, 1.0};

std::vector<SensorRole> responses_of(bool of_assembly, std::size_t file, const frf::FrfHeader& header) {
  std::vector<SensorRole> roles;
  for (const frf::Dof& dof : header.response) roles.push_back({of_assembly, file, false, dof});
  return roles;
}

/// Averages behind the variances that are taken from a file; 0: others are.
double averages_of(const Plan& plan, const frf::FrfHeader& header) {
  const VarianceOrigin origin = variance_origin(plan.scene, header);
  const bool counts = origin == VarianceOrigin::coherence || origin == VarianceOrigin::variance;
  return counts && header.averages >= 2.0 ? header.averages : 0.0;
}

}  // namespace

void ErrorTrials::add_sensors(const Plan& of) {
  const Observations& observations = *likelihood_plan(of)->observations;
  for_each_file(of, [&](bool of_assembly, std::size_t file, const frf::FrfHeader& header) {
    if (!of_assembly && observations.systematic_plan() != nullptr && !observations.systematic_plan()->scales(file).empty())
      return;
    for (const frf::Dof& dof : observations.layout().coordinates) {
      const bool response = frf::has(header.response, dof);
      if (!response && !frf::has(header.reference, dof)) continue;
      const SensorRole role{of_assembly, file, !response, dof};
      const SystematicPlan* declared = observations.systematic_plan();
      if (declared != nullptr && !declared->of(role).empty()) continue;
      plan.add({unit_gain, dof.name(), "", 0.0}, {role});
      sensors.push_back({dof, header.file, of_assembly});
    }
  });
}

void ErrorTrials::add_files(const Plan& of) {
  std::vector<SensorRole> assembly;
  for_each_file(of, [&](bool of_assembly, std::size_t file, const frf::FrfHeader& header) {
    const std::vector<SensorRole> roles = responses_of(of_assembly, file, header);
    if (of_assembly) assembly.insert(assembly.end(), roles.begin(), roles.end());
    if (of_assembly && file + 1 < of.assembly->source_count()) return;
    this->roles.push_back(of_assembly ? assembly : roles);
    plan.add({unit_gain, header.file, "", 0.0}, this->roles.back());
    const frf::FrfHeader& first = of_assembly ? of.assembly->source(0).header() : header;
    files.push_back({of_assembly, file, first.file, averages_of(of, first)});
  });
}

void ErrorTrials::add_stretches() {
  for (const std::vector<SensorRole>& of_file : roles) plan.add({{Systematic::stretch, 1.0}, "stretch", "", 0.0}, of_file);
  stretches = roles.size();
}

void ErrorTrials::add_references(const Plan& of) {
  const Dofs& coordinates = likelihood_plan(of)->observations->layout().coordinates;
  for (const bool is_phase : {false, true}) {
    const SystematicUnknown unknown{is_phase ? Systematic::delay : Systematic::gain, 1.0};
    for_each_file(of, [&](bool of_assembly, std::size_t file, const frf::FrfHeader& header) {
      if (averages_of(of, header) == 0.0) return;
      const std::size_t place = of_assembly ? 0 : file + 1;
      for (const frf::Dof& dof : header.reference) {
        if (!frf::has(coordinates, dof)) continue;
        plan.add({unknown, dof.name(), "", 0.0}, {{of_assembly, file, true, dof}});
        references.push_back({place, is_phase});
      }
    });
  }
}

}  // namespace jointid::ident
