#pragma once

#include <memory>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "ident/plan/model_in_use.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::ident {

using Sources = std::vector<std::unique_ptr<frf::FrfSource>>;

/// Opens the files of a system (headers only), with the corrections and virtual points of the scene, repeats as their mean. A file that
/// describes a model (models::is_model_file()) is one at the lines of the first file that is none. Throws InputError as frf::open(),
/// frf::corrected(), virtualpoint::virtual_source(), frf::mean_of_repeats() and models::open_model(), and where all files are models.
Sources open_all(const std::vector<DataFile>& files);

/// The same of several systems: a system of models alone has the lines of the first file of the others that is none, and where there is
/// none those of [frequency] range and step. `scene`: for the message where these are missing. `models` gets those that there are.
std::vector<Sources> open_systems(const std::vector<std::vector<DataFile>>& systems, const FrequencySection& frequency, const Path& scene,
                                  ModelsInUse* models = nullptr);

/// Substructures and assembly of a scene.
struct OpenedScene {
  Sources substructures, assembly;
  ModelsInUse models;
};
OpenedScene open_scene(const Scene& scene);

/// Of some file, [[virtual_points]] take the place of its sensors and impacts.
bool has_virtual_points(const Scene& scene);

}  // namespace jointid::ident
