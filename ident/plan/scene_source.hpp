#pragma once

#include <memory>
#include <vector>

#include "frf/set/frf_source.hpp"
#include "ident/plan/model_in_use.hpp"
#include "ident/scene/scene.hpp"
#include "models/model_source.hpp"

namespace jointid::ident {

/// A file with the corrections and virtual points that the scene gives it.
std::unique_ptr<frf::FrfSource> as_in_scene(std::unique_ptr<frf::FrfSource> source, const DataFile& file);

/// A model of a scene, whose FRFs are there at any lines.
class ModelFrfs {
 public:
  /// Throws InputError as models::read_model(), and where the scene states what only a measured file needs.
  explicit ModelFrfs(const DataFile& file);

  /// As the scene has them, at the lines that its corrections make `frequency_hz` of. All of them share the model.
  std::unique_ptr<frf::FrfSource> at(std::vector<double> frequency_hz) const;

  const std::shared_ptr<models::Model>& model() const { return named_.model; }

 private:
  DataFile file_;
  models::NamedModel named_;
};

}  // namespace jointid::ident
