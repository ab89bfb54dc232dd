#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "python/outcome.hpp"
#include "python/scene_text.hpp"
#include "study/comparison.hpp"

namespace jointid::python {

/// What `jointid study` is asked beside its scene.
struct StudyTask {
  std::size_t trials = 1000;
  std::uint64_t seed = 1;
  std::filesystem::path out;  ///< that keeps all trials
  bool resume = false;
};

/// `jointid study`, of scenes of friction laws too. Throws InputError and Interrupted; after that the trials so far are kept.
Outcome study(const SceneText& scene, const StudyTask& task, const ident::Control& control);

/// What `jointid compare` is asked beside its scene, in its words; empty lists: those of the scene.
struct CompareTask {
  std::size_t trials = 200;
  std::uint64_t seed = 1;
  std::vector<std::string> methods, weightings, solvers, regenerate;
  std::vector<std::vector<std::string>> equations;
  std::vector<double> deltas;
};

/// `jointid compare`, of scenes of friction laws too.
Outcome compare(const SceneText& scene, const CompareTask& task, const ident::Control& control, SoFar& so_far);

}  // namespace jointid::python
