#include "study/trial_regeneration.hpp"

#include <algorithm>

#include "ident/modal_regeneration.hpp"
#include "modalfit/model/regenerated_set.hpp"

namespace jointid::study {
namespace {

/// In place; variances only where the set has room for them.
void regenerate_polluted(frf::FrfSet& set, const modalfit::FitOptions& options) {
  frf::FrfSet measured = set;
  measured.variance.clear();
  measured.header.noise = measured.coherence.empty() ? frf::NoiseRecord::none : frf::NoiseRecord::coherence;
  modalfit::RegeneratedSet made = modalfit::regenerate_set(measured, options);
  set.values = std::move(made.set.values);
  if (made.set.variance.size() == set.variance.size()) set.variance = std::move(made.set.variance);
}

}  // namespace

Pollution with_regeneration(Pollution pollution, const ident::Scene& scene) {
  const ident::Regeneration chosen = scene.data.regenerate;
  if (!chosen.any()) return pollution;
  return [pollution = std::move(pollution), chosen, options = regeneration_options(scene)](
             std::uint64_t seed, std::uint64_t trial, Measurements& data) mutable {
    pollution(seed, trial, data);
    if (chosen.substructures)
      std::ranges::for_each(data.substructures, [&](frf::FrfSet& set) { regenerate_polluted(set, options); });
    if (chosen.assembly) std::ranges::for_each(data.assembly, [&](frf::FrfSet& set) { regenerate_polluted(set, options); });
  };
}

void declare_regeneration(TrialData& data) {
  const ident::Regeneration chosen = data.scene.data.regenerate;
  const auto declare = [](std::vector<frf::FrfSet>& sets) {
    for (frf::FrfSet& set : sets) {
      set.header.noise = frf::NoiseRecord::variance;
      set.variance.assign(set.values.size(), {});
    }
  };
  if (chosen.substructures) declare(data.base.substructures);
  if (chosen.assembly) declare(data.base.assembly);
}

}  // namespace jointid::study
