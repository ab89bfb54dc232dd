#include "ident/modal_regeneration.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "frf/merged_set.hpp"
#include "modalfit/regenerated_set.hpp"

namespace jointid::ident {
namespace {

/// Beyond each end of the range, so that modes just outside are fitted, too.
constexpr double margin = 0.1;

modalfit::FitOptions options_of(const Scene& scene) {
  modalfit::FitOptions options;
  options.kind = {modalfit::Damping::hysteretic, true};
  if (const auto& range = scene.frequency.range_hz) {
    const double more = margin * ((*range)[1] - (*range)[0]);
    options.range_hz = {(*range)[0] - more, (*range)[1] + more};
  }
  return options;
}

ModalRegeneration summary(const std::string& file, const modalfit::RegeneratedSet& set) {
  return {file, set.modes, set.error.rms_db_away, set.harm};
}

/// The files of a structure that is not one file.
std::vector<frf::FrfSet> load_structures(std::vector<std::unique_ptr<frf::FrfSource>>& sources, bool one_structure) {
  std::vector<frf::FrfSet> sets;
  for (const auto& source : sources) sets.push_back(frf::load(*source));
  if (!one_structure || sets.size() < 2) return sets;
  std::vector<frf::FrfSet> one;
  one.push_back(frf::merged(std::move(sets)));
  return one;
}

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

std::string note(const ModalRegeneration& of) {
  if (!of.harm.empty()) return of.file + ": regenerating these FRFs harms: " + of.harm;
  return of.file + ": FRFs regenerated from " + std::to_string(of.modes) + " modes, " +
         digits(of.rms_db_away) + " dB rms from the measured ones";
}

std::vector<std::unique_ptr<frf::FrfSource>> regenerate_sources(std::vector<std::unique_ptr<frf::FrfSource>> sources, bool one_structure,
                                                                const Scene& scene, std::vector<ModalRegeneration>& told) {
  std::vector<std::unique_ptr<frf::FrfSource>> out;
  for (const frf::FrfSet& measured : load_structures(sources, one_structure)) {
    modalfit::RegeneratedSet made = modalfit::regenerate_set(measured, options_of(scene));
    told.push_back(summary(measured.header.file, made));
    out.push_back(frf::from_memory(std::move(made.set)));
  }
  return out;
}

Pollution with_regeneration(Pollution pollution, const Scene& scene) {
  const Regeneration chosen = scene.data.regenerate;
  if (!chosen.any()) return pollution;
  return [pollution = std::move(pollution), chosen, options = options_of(scene)](std::uint64_t seed, std::uint64_t trial,
                                                                                 Measurements& data) mutable {
    pollution(seed, trial, data);
    if (chosen.substructures) std::ranges::for_each(data.substructures, [&](frf::FrfSet& set) { regenerate_polluted(set, options); });
    if (chosen.assembly) std::ranges::for_each(data.assembly, [&](frf::FrfSet& set) { regenerate_polluted(set, options); });
  };
}

void declare_regeneration(TrialData& data) {
  const Regeneration chosen = data.scene.data.regenerate;
  const auto declare = [](std::vector<frf::FrfSet>& sets) {
    for (frf::FrfSet& set : sets) {
      set.header.noise = frf::NoiseRecord::variance;
      set.variance.assign(set.values.size(), {});
    }
  };
  if (chosen.substructures) declare(data.base.substructures);
  if (chosen.assembly) declare(data.base.assembly);
}

}  // namespace jointid::ident
