#include "study/excerpt_pollution.hpp"

#include <optional>

#include "frf/noise/polluter.hpp"
#include "models/model_source.hpp"
#include "study/recorded_noise.hpp"

namespace jointid::study {
namespace {

/// Draws the errors of a set: a model's by its own noise, others' by a noise model.
class SetPollution {
 public:
  SetPollution(const frf::Excerpt& excerpt, frf::NoiseModel model) {
    const frf::FrfHeader& header = excerpt.set.header;
    if (models::is_model(header)) {
      recorded_.emplace(excerpt);
      return;
    }
    // The averages behind the coherences of a set are known better there than in the model.
    if (header.noise == frf::NoiseRecord::coherence && header.averages >= 2.0) model.averages = static_cast<int>(header.averages);
    law_.emplace(excerpt, model);
  }

  void pollute(frf::FrfSet& set, const RandomStream& stream) {
    if (law_) law_->pollute(set, stream);
    if (recorded_) recorded_->pollute(set, stream);
  }

 private:
  std::optional<frf::Polluter> law_;
  std::optional<RecordedNoise> recorded_;
};

}  // namespace

Pollution pollution_of(const Excerpts& excerpts, const frf::NoiseModel& model, const SystematicNoise& systematic) {
  std::vector<SetPollution> substructures, assembly;
  for (const frf::Excerpt& excerpt : excerpts.substructures) substructures.emplace_back(excerpt, model);
  for (const frf::Excerpt& excerpt : excerpts.assembly) assembly.emplace_back(excerpt, model);
  return [substructures, assembly, systematic](std::uint64_t seed, std::uint64_t trial, Measurements& data) mutable {
    if (systematic.any()) {
      for (auto* sets : {&data.substructures, &data.assembly}) {
        for (frf::FrfSet& each : *sets) {
          if (!models::is_model(each.header)) systematic.apply(each, {seed, trial, 0});
        }
      }
    }
    std::uint64_t set = 0;
    for (std::size_t i = 0; i < substructures.size(); ++i) {
      substructures[i].pollute(data.substructures[i], {seed, trial, set++});
    }
    for (std::size_t i = 0; i < assembly.size(); ++i) assembly[i].pollute(data.assembly[i], {seed, trial, set++});
  };
}

Pollution recorded_pollution(const Excerpts& excerpts) {
  std::vector<RecordedNoise> substructures, assembly;
  for (const frf::Excerpt& excerpt : excerpts.substructures) substructures.emplace_back(excerpt);
  for (const frf::Excerpt& excerpt : excerpts.assembly) assembly.emplace_back(excerpt);
  return [substructures, assembly](std::uint64_t seed, std::uint64_t trial, Measurements& data) {
    std::uint64_t set = 0;
    for (std::size_t i = 0; i < substructures.size(); ++i) substructures[i].pollute(data.substructures[i], {seed, trial, set++});
    for (std::size_t i = 0; i < assembly.size(); ++i) assembly[i].pollute(data.assembly[i], {seed, trial, set++});
  };
}

}  // namespace jointid::study
