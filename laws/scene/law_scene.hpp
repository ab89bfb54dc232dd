#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ident/scene/scene.hpp"
#include "ident/scene/scene_files.hpp"
#include "records/file/read_record.hpp"
#include "response/identify/law_constraints.hpp"
#include "response/joint/joint.hpp"

namespace jointid::laws {

/// One of [[joint.friction]]: a relative coordinate between two DOFs, or from one to ground.
struct FrictionJoint {
  frf::Dof positive;
  std::optional<frf::Dof> negative;
  std::vector<std::string> laws;  ///< to choose from, at least one; those of the joint that it is tied to
  std::vector<double> assumed{};  ///< values of the parameters of the law assumed, for plans; empty when the scene tells none
  std::string assumed_law{};      ///< one of `laws`
  response::Joint beside;         ///< name and the spring, dashpot and cubic spring beside the law
};

/// The files of one harmonic, which other harmonics may share; its lines are at nω, the frequencies of the phasors themselves.
struct HarmonicFiles {
  int harmonic = 1;
  ident::DataFile responses;
  std::optional<ident::DataFile> forces;
};

/// Time records of a level, of which phasors are taken.
struct LevelRecords {
  std::vector<ident::Path> files;
  records::RecordOptions options;
  std::vector<double> lines_hz;  ///< of the force of each record, as it was set; empty: found
  double settle_s = 0.0;         ///< left out at the start of each
  bool sweep = false;            ///< one slow sweep each; else steady vibration
  int periods = 20;              ///< of a window of a sweep
};

/// One of [[data.levels]]: what was measured of the assembly at one force level.
struct ForceLevel {
  std::string name;
  bool planned = false;  ///< nothing was measured yet: no files, an amplitude
  std::vector<HarmonicFiles> harmonics;   ///< ascending; without files where there are records
  std::optional<LevelRecords> records{};  ///< in place of all files of phasors
  std::vector<frf::Dof> force_dofs;
  std::optional<double> amplitude;  ///< N, of harmonic 1 at the one force DOF; without files of forces
  bool rms = false;                 ///< the files hold root mean squares: peaks are √2 times their phasors (not of `per_force`)
  bool per_force = false;           ///< the responses are over the phasor of harmonic 1 of the force: FRFs at that level
};

/// Standard deviations of phasors whose files tell none: σ² = (relative·|Y|)²/2 + floor² of real and imaginary part each.
struct PhasorErrors {
  double relative = 0.0;
  double floor = 0.0;  ///< m
  double force = 0.0;  ///< σ² of Re P and Im P each = (force·|P|)²/2, of forces whose files tell none

  bool of_responses() const { return relative > 0.0 || floor > 0.0; }
};

/// A scene of friction joints identified from vibration, checked for all that can be checked without opening the data.
struct LawScene {
  ident::Path file;
  std::string title;
  std::vector<ident::DataFile> parts;
  bool reciprocity = false;
  std::vector<ForceLevel> levels;
  ident::FrequencySection frequency;  ///< of the forces: ω/2π
  std::vector<frf::Dof> responses;    ///< those used; empty: all that every level and the parts have
  std::vector<FrictionJoint> joints;
  response::LawConstraints constraints;
  std::optional<PhasorErrors> errors;
  std::vector<int> harmonics;  ///< of the model; empty: added until they do not matter
};

/// Names of the levels, in their order.
std::vector<std::string> level_names(const LawScene& scene);

/// The scene and every file that it names.
std::vector<ident::NamedFile> files_of(const LawScene& scene);

}  // namespace jointid::laws
