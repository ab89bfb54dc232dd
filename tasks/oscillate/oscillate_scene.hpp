#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ident/scene/scene_files.hpp"
#include "oscillation/system/normal_vibration.hpp"
#include "tasks/oscillate/oscillate_system.hpp"

namespace jointid::tasks {

/// [motion]: what is sampled. All times in s.
struct MotionSection {
  double transient = 0.0;  ///< left out
  double length = 0.0;     ///< > 0
  double step = 0.0;       ///< between samples, > 0
};

/// [orbit]: a periodic orbit near the end of the motion.
struct OrbitSection {
  std::size_t returns = 1;  ///< break-aways of a period, or cycles of the drive
};

/// [exponents]
struct ExponentSection {
  std::size_t count = 1;
  double transient = 0.0, length = 0.0, interval = 0.0;
};

/// [sweep]: a bifurcation diagram over one number of the system.
struct SweepSection {
  std::string parameter;
  double from = 0.0, to = 0.0;
  std::size_t points = 0;
  double transient = 0.0, length = 0.0;  ///< s; of a driven system cycles
  bool continued = false;                ///< each parameter from the last state of the one before, in the order of the range
  bool back = false;                     ///< and back again, from the last state of all
  bool reduced = false;                  ///< the same sweep of the models of [reduction]

  /// Range, period and stick of each parameter are found, too.
  bool ranges() const { return continued || reduced; }
};

/// [normal_vibrations]: how the normal load varies where the slider's plane is not quite level.
struct NormalVibrationSection {
  oscillation::NormalVibration system;
  std::vector<double> frequencies_hz;  ///< of the slider, > 0
};

enum class BasisKind { pod, normal_modes, craig_bampton };
std::string word(BasisKind kind);

/// [reduction]: models on fewer coordinates beside the full one.
struct ReductionSection {
  std::vector<BasisKind> bases;
  std::vector<std::size_t> orders;
  bool from_orbit = false;            ///< one period of the orbit; else the motion of the scene
  std::optional<ident::Path> record;  ///< columns q1 … qn for the proper orthogonal modes; default: the motion itself
};

/// A scene of `jointid oscillate`, checked for everything that can be checked without computing.
struct OscillateScene {
  ident::Path file;
  std::string title;
  std::vector<ident::NamedFile> named;  ///< files that the scene names
  SystemSpec system;
  Eigen::VectorXd q, v;  ///< start
  MotionSection motion;
  std::optional<OrbitSection> orbit;
  std::optional<ExponentSection> exponents;
  std::optional<SweepSection> sweep;
  std::optional<ReductionSection> reduction;
  std::optional<NormalVibrationSection> normal_vibrations;
};

/// The scene and every file that it names.
std::vector<ident::NamedFile> files_of(const OscillateScene& scene);

/// Throws InputError (usage) with line and key of what is wrong; (data) for files of matrices.
OscillateScene read_oscillate_scene(const ident::Path& file);
OscillateScene parse_oscillate_scene(const std::string& text, const ident::Path& file);

}  // namespace jointid::tasks
