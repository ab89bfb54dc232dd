#include "ident/scene/variance_origin.hpp"

#include <array>

#include "ident/scene/scene_failure.hpp"
#include "models/model_source.hpp"
#include "scene/reader.hpp"

namespace jointid::ident {
namespace {

[[noreturn]] void refuse(const frf::FrfHeader& header, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::data,
                    .file = header.file,
                    .place = "variances",
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

bool has_averages(const frf::FrfHeader& header) { return header.averages >= 2.0; }

bool is_usable(const frf::FrfHeader& header) {
  return header.noise == frf::NoiseRecord::variance ||
         (header.noise == frf::NoiseRecord::coherence && has_averages(header));
}

VarianceOrigin of_file(const frf::FrfHeader& header) {
  constexpr auto otherwise =
      "take more averages, repeat the measurement, give a [noise] section with model and level, or variance = \"local\"";
  if (header.repeats > 0) return VarianceOrigin::repeats;
  if (header.noise == frf::NoiseRecord::variance) return VarianceOrigin::variance;
  if (header.noise == frf::NoiseRecord::none) refuse(header, "the file has neither variances nor coherences", otherwise);
  if (has_averages(header)) return VarianceOrigin::coherence;
  if (header.averages > 0.0) {
    refuse(header, "coherences of " + scene::number_text(header.averages) + " average(s) are 1 whatever the noise is",
           otherwise);
  }
  refuse(header, "the file does not state how many averages are behind its coherences",
         "give their number in the file, or a [noise] section with model and level");
}

VarianceOrigin of_noise(const Scene& scene) {
  require_noise_law(scene);
  return VarianceOrigin::noise_model;
}

}  // namespace

void require_noise_law(const Scene& scene) {
  if (!scene.noise) fail(scene, "[identify] variance", "\"noise\" needs a [noise] section", "add it with model and level");
  if (scene.noise->model == "modal") {
    fail(scene, "[noise] model", "model \"modal\" gives no variance of a single FRF",
         "use uniform, gaussian, circular or hammer");
  }
}

std::string phrase(VarianceOrigin origin) {
  constexpr std::array phrases = {"variances in the file", "scatter of repeated runs",
                                  "coherences and averages of the file", "the law of [noise]",
                                  "estimated from the scatter of the data", "a model, as exact as it states"};
  return phrases[static_cast<std::size_t>(origin)];
}

VarianceOrigin variance_origin(const Scene& scene, const frf::FrfHeader& header) {
  if (models::is_model(header)) return VarianceOrigin::model;
  switch (scene.identify.variance) {
    case VarianceChoice::file:
      return of_file(header);
    case VarianceChoice::noise:
      return of_noise(scene);
    case VarianceChoice::local:
      return VarianceOrigin::scatter;
    case VarianceChoice::automatic:
      break;
  }
  if (is_usable(header)) return of_file(header);
  if (scene.noise) return of_noise(scene);
  return header.averages > 0.0 ? of_file(header) : VarianceOrigin::scatter;
}

}  // namespace jointid::ident
