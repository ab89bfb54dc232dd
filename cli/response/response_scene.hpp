#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ident/scene/scene.hpp"
#include "ident/scene/scene_files.hpp"
#include "response/harmonic/harmonic_balance.hpp"
#include "response/structure/matrix_structure.hpp"

namespace jointid::cli {

/// A degree of freedom as the scene names it: a coordinate of matrices, from 0, or a DOF of files.
struct SceneDof {
  std::string name;
  Eigen::Index coordinate = 0;
  frf::Dof dof{};
};

/// One of [[joints]]: between two DOFs, or from one to ground.
struct SceneJoint {
  SceneDof positive;
  std::optional<SceneDof> negative;
  response::Joint joint;
  std::vector<double> deviations{};  ///< of the law's parameters; none when nothing is said
};

enum class CurveMethod { sweep, arc_length };

/// A scene of `jointid response`, checked for everything that can be checked without the FRFs.
struct ResponseScene {
  ident::Path file;
  std::string title;
  std::vector<ident::DataFile> parts;  ///< [data]; none with matrices
  bool reciprocity = false;
  std::optional<response::MatrixStructure> structure;  ///< [structure]
  std::vector<ident::NamedFile> matrix_files;
  std::vector<SceneJoint> joints;
  SceneDof force_dof;
  std::vector<double> levels;  ///< [force] amplitudes, N
  response::Excitation force;  ///< of level 1
  std::optional<ident::Range> range_hz;
  std::vector<double> values_hz;  ///< these instead
  std::size_t points = 201;       ///< over the range, of matrices
  std::vector<SceneDof> responses;
  response::HarmonicChoice harmonics;
  CurveMethod method = CurveMethod::sweep;
};

/// The scene and every file that it names.
std::vector<ident::NamedFile> files_of(const ResponseScene& scene);

}  // namespace jointid::cli
