#include "ident/modal_regeneration.hpp"

#include <algorithm>

#include "base/text.hpp"
#include "frf/set/merged_set.hpp"
#include "modalfit/model/regenerated_set.hpp"

namespace jointid::ident {
namespace {

/// Beyond each end of the range, so that modes just outside are fitted, too.
constexpr double margin = 0.1;

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

}  // namespace

modalfit::FitOptions regeneration_options(const Scene& scene) {
  modalfit::FitOptions options;
  options.kind = {modalfit::Damping::hysteretic, true};
  if (const auto& range = scene.frequency.range_hz) {
    const double more = margin * ((*range)[1] - (*range)[0]);
    options.range_hz = {(*range)[0] - more, (*range)[1] + more};
  }
  return options;
}

std::string note(const ModalRegeneration& of) {
  if (!of.harm.empty()) return of.file + ": synthesised FRFs are worse than the measured ones: " + of.harm;
  return of.file + ": FRFs synthesised from " + std::to_string(of.modes) + " modes, " + digits(of.rms_db_away) +
         " dB rms from the measured ones";
}

std::vector<std::unique_ptr<frf::FrfSource>> regenerate_sources(std::vector<std::unique_ptr<frf::FrfSource>> sources, bool one_structure,
                                                                const Scene& scene, std::vector<ModalRegeneration>& told) {
  std::vector<std::unique_ptr<frf::FrfSource>> out;
  for (const frf::FrfSet& measured : load_structures(sources, one_structure)) {
    modalfit::RegeneratedSet made = modalfit::regenerate_set(measured, regeneration_options(scene));
    told.push_back(summary(measured.header.file, made));
    out.push_back(frf::from_memory(std::move(made.set)));
  }
  return out;
}

}  // namespace jointid::ident
