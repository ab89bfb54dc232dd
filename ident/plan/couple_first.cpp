#include "ident/plan/couple_first.hpp"

#include "coupling/coupled_source.hpp"
#include "ident/scene/scene_failure.hpp"

namespace jointid::ident {
namespace {

bool says_its_noise(const frf::FrfHeader& header) {
  return header.noise == frf::NoiseRecord::variance || (header.noise == frf::NoiseRecord::coherence && header.averages >= 2.0);
}

/// Whether variances go through the coupling, and by which law where files have none.
void choose_uncertainty(Scene& scene, const frf::FrfSystem& substructures, coupling::Options& options) {
  if (scene.identify.variance == VarianceChoice::local) return;
  const bool uses_variances = traits(scene.identify.method).uses_variances;
  bool all = true, any = false;
  for (std::size_t s = 0; s < substructures.source_count(); ++s) {
    const bool says = says_its_noise(substructures.source(s).header());
    all = all && says;
    any = any || says;
  }
  const bool law = scene.noise && scene.noise->model != "modal" && scene.identify.variance != VarianceChoice::file;
  if (law) options.noise = scene.noise->frf_model;
  if (scene.identify.variance == VarianceChoice::noise) {
    if (any && uses_variances) {
      fail(scene, "[identify] variance", "couple_first carries the variances of the files through", "remove variance = \"noise\"");
    }
    scene.identify.variance = VarianceChoice::automatic;
  }
  const bool must = uses_variances && scene.identify.variance == VarianceChoice::file;
  options.uncertainty = all || law || must;
}

}  // namespace

std::shared_ptr<frf::FrfSystem> couple_first(Scene& scene, std::shared_ptr<frf::FrfSystem> substructures, std::vector<std::string>& notes) {
  if (scene.couple_first.pairs.empty()) return substructures;
  coupling::Assembly assembly;
  std::string text;
  for (const auto& [first, second] : scene.couple_first.pairs) {
    assembly.join.push_back({{{}, first}, {{}, second}});
    text += (text.empty() ? "" : ", ") + first.name() + " = " + second.name();
  }
  for (const frf::Dof& dof : scene.couple_first.hidden) assembly.hide.push_back({{}, dof});
  coupling::Options options;
  options.threads = 1;  // studies run many at a time
  choose_uncertainty(scene, *substructures, options);
  notes.push_back("Coupled rigidly before the identification: " + text + ".");
  const std::string where = scene.file.string() + ": couple_first";
  std::vector<std::unique_ptr<frf::FrfSource>> sources;
  sources.push_back(coupling::as_source(std::make_unique<coupling::AssemblyReader>(
      std::vector<coupling::Part>{{"substructures", std::move(substructures)}}, assembly, options, where)));
  return std::make_shared<frf::FrfSystem>("substructures", std::move(sources), frf::Composition::uncoupled, scene.data.reciprocity);
}

}  // namespace jointid::ident
