#pragma once

#include <string>
#include <vector>

#include "laws/scene/law_scene.hpp"
#include "response/identify/law_fit.hpp"

namespace jointid::laws {

/// What a set of levels would tell of the joints: deviations at the bound, of states that are those of the laws assumed.
struct LevelsBound {
  response::LawFitEnd status = response::LawFitEnd::converged;
  std::vector<response::FittedJoint> joints;  ///< none where harmonic balance has no solution
  std::vector<std::string> unseen;            ///< one phrase each, with the joint's name
  /// Geometric mean of the relative deviations of all stiffnesses and limits, each at most 1000; NaN without joints.
  double size = 0.0;
};

/// One planned level, and the bound of the measured levels and it, or, where none was measured, of all levels but it.
struct LevelWorth {
  std::size_t level = 0;  ///< of the scene
  LevelsBound bound;
};

/// The bound of a scene of friction joints before all of it is measured.
struct LawBound {
  std::vector<std::string> laws;     ///< of each joint
  bool assumed = false;              ///< the laws are those of the scene, else those that the measured levels give
  std::vector<double> lines_hz;      ///< of the force, all that some level has
  std::vector<int> harmonics;        ///< of the model
  std::size_t measured = 0;          ///< levels
  LevelsBound all;                   ///< of all levels together
  LevelsBound present;               ///< of the measured ones; no joints when there is none
  std::vector<LevelWorth> worth;     ///< of each planned level, the one worth most first
  std::vector<std::string> notes;
};

/// Reads the parts (and the measured levels), solves harmonic balance at each level and line for the assumed laws, and takes the
/// information of these states (response::bound_of_laws) with the errors that [errors], the files and the parts' variances tell. Throws
/// InputError (data) without laws to assume, and without [errors] for a planned level.
LawBound predict_law_bound(const LawScene& scene);

}  // namespace jointid::laws
