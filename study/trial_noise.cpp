#include "study/trial_noise.hpp"

#include "models/model_source.hpp"

namespace jointid::study {
namespace {

void declare(const frf::NoiseModel& model, frf::FrfSet& set) {
  if (models::is_model(set.header)) return;
  set.variance.clear();
  set.header.repeats = 0;
  if (model.kind == frf::NoiseKind::hammer) {
    if (set.coherence.empty()) set.coherence.assign(set.values.size(), model.coherence);
    const bool has_averages = set.header.noise == frf::NoiseRecord::coherence && set.header.averages >= 2.0;
    set.header.averages = has_averages ? static_cast<int>(set.header.averages) : model.averages;
    set.header.noise = frf::NoiseRecord::coherence;
    return;
  }
  set.coherence.clear();
  set.header.averages = 0.0;
  set.header.noise = frf::NoiseRecord::none;
}

}  // namespace

void declare_noise(const frf::NoiseModel& model, TrialData& data) {
  for (auto* sets : {&data.base.substructures, &data.base.assembly}) {
    for (frf::FrfSet& set : *sets) declare(model, set);
  }
  data.scene.noise = ident::NoiseSection{.model = frf::name(model.kind), .level = model.level, .frf_model = model};
  ident::VarianceChoice& choice = data.scene.identify.variance;
  if (choice == ident::VarianceChoice::file && model.kind != frf::NoiseKind::hammer) choice = ident::VarianceChoice::noise;
}

}  // namespace jointid::study
