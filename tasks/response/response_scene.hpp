#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ident/scene/scene.hpp"
#include "ident/scene/scene_files.hpp"
#include "response/harmonic/harmonic_balance.hpp"
#include "response/structure/matrix_structure.hpp"
#include "response/structure/sparse_receptance.hpp"
#include "response/time/transient.hpp"

namespace jointid::tasks {

/// A degree of freedom of the scene: a coordinate of matrices, from 0, or a DOF of files.
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
  std::vector<double> deviations{};  ///< standard deviations of the law's parameters; empty if none is given
};

enum class CurveMethod { sweep, arc_length };

/// One of [[curves]]: along the force level, or along a parameter of a joint, at one frequency.
struct SceneCurve {
  std::string along;                                    ///< "force", or the parameter's name
  std::optional<response::JointParameter> parameter{};  ///< none along the force
  std::array<double, 2> range{};                        ///< from, to
  double frequency_hz = 0.0;
  double force = 1.0;  ///< N, along a parameter
};

/// [equivalent]: joints as springs and dampers over amplitude, and the modes with them.
struct SceneEquivalent {
  std::vector<double> amplitudes;    ///< |Q₁|, m
  std::optional<Eigen::Index> mode;  ///< of matrices, from 0
  std::size_t joint = 0;             ///< whose amplitude it is
};

/// [clamping]: which normal load of friction joints makes the peak of the response least.
struct SceneClamping {
  std::vector<std::size_t> joints;    ///< of [[joints]], all with a law; clamped alike
  std::array<double, 2> range{};      ///< of the normal load over the one that the laws belong to
  std::size_t points = 13;            ///< over the range, in proportion
  std::optional<double> nominal{};    ///< the load that the laws belong to, N
};

/// A force of [transient] from a file of time records.
struct SceneRecord {
  SceneDof dof;
  ident::NamedFile file;
  std::string column, unit, time;  ///< unit: empty for that of the file, else N
  double factor = 1.0;
  std::optional<double> rate_hz;
};

/// A half sine of [transient]: amplitude · sin(πt/length) for t < length.
struct ScenePulse {
  SceneDof dof;
  double amplitude = 0.0, length = 0.0;
};

/// A changing normal load of [transient] on one joint.
struct SceneNormal {
  std::size_t joint = 0;  ///< of [[joints]]
  response::NormalLoad load;
};

/// [transient]: the motion from rest under pulses or records, or under [force] at the first frequency.
struct SceneTransient {
  double duration = 0.0, step = 0.0;  ///< s; step of the output
  response::TransientMethod method = response::TransientMethod::exact;
  double delta = 0.0;  ///< of Algorithms One and Two, s; divides `step`
  std::vector<SceneRecord> records;
  std::vector<ScenePulse> pulses;             ///< one run each
  std::vector<SceneNormal> normal{};          ///< of the algorithms
  response::AlgorithmTwoOptions two{};        ///< weight, k_r of [[joints]] with friction, start
  std::vector<double> reference_stiffness{};  ///< k_r of each of [[joints]], N/m; empty: that of the law
};

/// A scene of `jointid response`. It is checked as far as possible without the FRFs.
struct ResponseScene {
  ident::Path file;
  std::string title;
  std::vector<ident::DataFile> parts;  ///< [data]; none with matrices
  bool reciprocity = false;
  std::optional<response::MatrixStructure> structure;  ///< [structure] of at most most_full coordinates, or with modal_damping …
  std::optional<response::SparseStructure> sparse;     ///< … or of more
  std::optional<Eigen::Index> modes;                   ///< free modes on which it marches in time
  std::vector<ident::NamedFile> matrix_files;
  std::vector<SceneJoint> joints;
  SceneDof force_dof;
  std::vector<double> levels;  ///< [force] amplitudes (force levels), N
  response::Excitation force;  ///< of level 1
  std::optional<ident::Range> range_hz;
  std::vector<double> values_hz;  ///< these frequencies instead
  std::size_t points = 201;       ///< over the range, of matrices and modal models
  bool modal_model = false;       ///< FRFs of parts by their modal models, at any frequency
  std::vector<SceneDof> responses;
  response::HarmonicChoice harmonics;
  CurveMethod method = CurveMethod::sweep;
  bool stability = false;
  std::vector<SceneCurve> curves;
  std::optional<SceneEquivalent> equivalent;
  std::optional<SceneClamping> clamping{};
  std::optional<SceneTransient> transient;
};

/// Number of coordinates above which [structure] stays sparse.
inline constexpr Eigen::Index most_full = 300;

/// Number of coordinates of [structure]; 0 with files.
Eigen::Index coordinates(const ResponseScene& scene);

/// Whether it can march in time: at most most_full coordinates, or condensed to modes.
bool marches(const ResponseScene& scene);

/// The scene file and every file that it names.
std::vector<ident::NamedFile> files_of(const ResponseScene& scene);

}  // namespace jointid::tasks
