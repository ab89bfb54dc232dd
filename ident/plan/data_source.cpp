#include "ident/plan/data_source.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "frf/noise/repeats.hpp"
#include "ident/plan/scene_source.hpp"
#include "models/model_file.hpp"

namespace jointid::ident {
namespace {

std::unique_ptr<frf::FrfSource> open_run(const DataFile& file) { return as_in_scene(frf::open(file.path, file.options), file); }

bool is_model(const DataFile& file) { return models::is_model_file(file.path); }

std::unique_ptr<frf::FrfSource> open(const DataFile& file) {
  if (file.repeats.empty()) return open_run(file);
  Sources runs;
  runs.push_back(open_run(file));
  for (const DataFile& run : file.repeats) runs.push_back(open_run(run));
  return frf::mean_of_repeats(std::move(runs));
}

[[noreturn]] void refuse(const Path& file, std::string place, std::string problem, std::string remedy) {
  throw InputError({.kind = ErrorKind::usage,
                    .file = file.string(),
                    .place = std::move(place),
                    .problem = std::move(problem),
                    .remedy = std::move(remedy)});
}

void require_single(const DataFile& file) {
  for (const DataFile& run : file.repeats) {
    if (is_model(file) || is_model(run)) refuse(run.path, "[data]", "a model is among repeats", "a model has no scatter: name it alone");
  }
}

/// Files that are no models, in their places; nothing in those of models.
Sources open_measured(const std::vector<DataFile>& files) {
  Sources sources;
  for (const DataFile& file : files) {
    require_single(file);
    sources.push_back(is_model(file) ? nullptr : open(file));
  }
  return sources;
}

/// The lines of the first source that is there; none where there is none.
std::vector<double> lines_of(const Sources& sources) {
  for (const auto& source : sources) {
    if (source) return source->header().frequency_hz;
  }
  return {};
}

/// lo, lo + step, … hi; none unless both are given.
std::vector<double> lines_of(const FrequencySection& frequency) {
  std::vector<double> lines;
  if (!frequency.range_hz || !frequency.step_hz) return lines;
  const auto [lo, hi] = *frequency.range_hz;
  const auto steps = static_cast<std::size_t>(std::floor((hi - lo) / *frequency.step_hz * (1.0 + 1e-12)));
  for (std::size_t i = 0; i <= steps; ++i) lines.push_back(lo + static_cast<double>(i) * *frequency.step_hz);
  return lines;
}

}  // namespace

Sources open_all(const std::vector<DataFile>& files) { return std::move(open_systems({files}, {}, {}).front()); }

std::vector<Sources> open_systems(const std::vector<std::vector<DataFile>>& systems, const FrequencySection& frequency, const Path& scene,
                                  ModelsInUse* models) {
  std::vector<Sources> all;
  std::vector<double> others;
  for (const std::vector<DataFile>& files : systems) {
    all.push_back(open_measured(files));
    if (others.empty()) others = lines_of(all.back());
  }
  if (others.empty()) others = lines_of(frequency);
  for (std::size_t s = 0; s < systems.size(); ++s) {
    std::vector<double> lines = lines_of(all[s]);
    if (lines.empty()) lines = others;
    for (std::size_t i = 0; i < systems[s].size(); ++i) {
      if (all[s][i]) continue;
      if (lines.empty()) refuse(scene, "[frequency]", "all files are models, which have every frequency", "give range and step");
      const ModelFrfs frfs(systems[s][i]);
      all[s][i] = frfs.at(lines);
      if (models != nullptr) models->push_back({systems[s][i].path.string(), all[s][i]->header().response, frfs.model()});
    }
  }
  return all;
}

OpenedScene open_scene(const Scene& scene) {
  OpenedScene out;
  auto systems = open_systems({scene.data.substructures, scene.data.assembly}, scene.frequency, scene.file, &out.models);
  out.substructures = std::move(systems[0]);
  out.assembly = std::move(systems[1]);
  return out;
}

bool has_virtual_points(const Scene& scene) {
  const auto has = [](const DataFile& file) { return !file.virtual_points.empty(); };
  return std::ranges::any_of(scene.data.substructures, has) || std::ranges::any_of(scene.data.assembly, has);
}

}  // namespace jointid::ident
