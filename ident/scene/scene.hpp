#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "frf/noise/noise.hpp"
#include "frf/set/corrections.hpp"
#include "frf/set/frf_source.hpp"
#include "ident/scene/method_traits.hpp"
#include "ident/scene/systematic_errors.hpp"
#include "restrictions/joint_spec.hpp"
#include "scene/value.hpp"
#include "virtualpoint/virtual_point.hpp"
#include "weighting/weighting.hpp"

namespace jointid::ident {

using scene::Matrix;
using scene::Path;
using scene::Range;

/// A file, with the scene's missing information and corrections for it ([data.files."name"]).
struct DataFile {
  Path path;  ///< resolved against the folder of the scene
  frf::OpenOptions options;
  std::vector<DataFile> repeats{};  ///< further runs of the same measurement
  frf::Corrections corrections{};   ///< of its FRFs
  std::vector<virtualpoint::VirtualPoint> virtual_points{};  ///< their coordinates replace its sensors and impacts
  std::optional<frf::NoiseModel> virtual_noise{};  ///< noise model of these FRFs, if the file has none ([noise])
  std::optional<Path> model{};      ///< description of a model of the same structure, which `check` holds the file against
  std::optional<double> mass{};     ///< kg, of the structure, which hung free; `check` compares it with the rigid-body lines
  std::optional<Path> nodes{};      ///< positions of its nodes (frf::read_node_table()), before those that it states itself
};

/// Which systems' FRFs a modal model replaces.
struct Regeneration {
  bool substructures = false, assembly = false;

  bool any() const { return substructures || assembly; }
  bool operator==(const Regeneration&) const = default;
};

/// "none", "substructures", "assembly" or "substructures+assembly".
std::string name(const Regeneration& regeneration);

/// Parses such a name; throws InputError (usage) with the nearest valid word.
Regeneration parse_regeneration(const std::string& text);

struct DataSection {
  std::vector<DataFile> substructures;  ///< uncoupled: FRFs across two files are zero by construction
  std::vector<DataFile> assembly;
  Regeneration regenerate{};  ///< by modal models, before anything else
  bool reciprocity = false;  ///< on request: reciprocity replaces a missing FRF
  std::vector<GainPrior> gains{};   ///< of method likelihood
  std::vector<MassPrior> masses{};  ///< those that are not exactly known; of method likelihood
};

/// Leaves out lines within half_width·f of every resonance f found in the data.
struct ResonanceExclusion {
  bool of_substructures = false;
  bool of_assembly = false;
  double half_width = 0.01;  ///< relative, 0 < half_width < 1
};

struct FrequencySection {
  std::optional<Range> range_hz;
  std::optional<double> step_hz;  ///< > 0: the lines nearest to lo, lo+step, …
  std::vector<Range> exclude_hz;
  std::optional<ResonanceExclusion> exclude_resonances;
};

/// The block of the assembly that an equation explains (docs/formulas.md §2), or that Z_j multiplies (§3).
enum class Equation { nn, nj, jj, jn };

std::string name(Equation equation);

/// The equation by name; throws InputError (usage) with the nearest valid word.
Equation parse_equation(const std::string& text);

/// Source of the variances of the FRFs.
enum class VarianceChoice {
  automatic,  ///< those of each file; else the model of [noise]; else the scatter of the data
  file,       ///< variances or coherences of the files
  noise,      ///< the model of [noise], whatever the files have
  local       ///< estimated from the scatter of the data about smooth local models
};

/// Prior knowledge of an unknown: a normal distribution.
struct Prior {
  std::string unknown;     ///< its name as printed, "K(1,1)"
  double value = 0.0;      ///< SI
  double deviation = 1.0;  ///< standard deviation, SI, > 0
};

/// lower ≤ unknown ≤ upper; one of them may be infinite.
struct Bound {
  std::string unknown;  ///< its name as printed
  double lower = 0.0, upper = 0.0;  ///< SI
};

struct IdentifySection {
  Method method = Method::one;
  bool automatic = false;     ///< the plan chooses the method (automatic_method.hpp): scene files that name none, or "auto"
  bool any_weighting = false;  ///< the scene names neither weighting nor delta
  std::vector<Equation> equations;  ///< no duplicates; empty: all that the data allow
  weighting::Weighting weighting = weighting::Weighting::wb;
  double delta = 0.0;  ///< 0 ≤ Δ < 2
  Solver solver = Solver::automatic;
  VarianceChoice variance = VarianceChoice::automatic;
  /// Variances of files: σ² = a|H|² + b fitted to each FRF. Empty: if they are from few averages or repeats, over enough lines.
  std::optional<bool> smooth_variance;
  std::map<restrictions::Kind, Matrix> start;
  std::size_t starts = 0;  ///< of iterative methods, all are followed; 0: until one is good enough
  std::vector<Prior> priors;  ///< of method likelihood
  std::vector<Bound> bounds;
  std::vector<std::string> ties;  ///< linear equations between unknowns: "K(1,1) = K(2,2)"
  std::vector<std::string> inequalities;  ///< linear ones: "0.01*K(1,1) <= D(1,1) <= 0.1*K(1,1)"
  std::optional<Range> passive_hz;  ///< Im Z_J is positive semidefinite from the first of these frequencies to the second
  std::vector<double> frequencies_hz;  ///< eigenfrequencies of the assembly, as conditions on the joint
  bool loose = false;  ///< the joints are nominal ones times a share each, and the result tells which are loose
  std::size_t bootstrap = 0;  ///< replicates of the parametric bootstrap of method likelihood; 0: none
  std::uint64_t bootstrap_seed = 1;
};

/// Pairs of coordinates that are coupled rigidly before the identification (docs/formulas.md §4). The joints of a scene are those
/// that remain, see reduce_joints().
struct CoupleFirst {
  std::vector<std::array<frf::Dof, 2>> pairs;
  std::vector<frf::Dof> hidden;  ///< resulting coordinates without a joint; their FRFs are not used
};

struct NoiseSection {
  std::string model;  ///< uniform | gaussian | circular | hammer | modal
  double level = 0.0;
  frf::NoiseModel frf_model;  ///< the whole section, for every model but modal
  double gain_errors = 0.0;   ///< of studies: standard deviation of the gain of the sensor at a DOF, the same in all files
  double mass_errors = 0.0;   ///< of studies: kg, of the mass of the roving sensor at a DOF, the same in all files
};

/// A scene file. It is checked as far as possible without opening the data.
struct Scene {
  Path file;
  std::string title;
  DataSection data;
  FrequencySection frequency;
  std::vector<restrictions::JointSpec> joints;  ///< [joint] or [[joints]]
  CoupleFirst couple_first;
  IdentifySection identify;
  std::optional<NoiseSection> noise;
  std::map<restrictions::Kind, Matrix> truth;  ///< over all joint DOFs in order; absent matrices are not compared
};

}  // namespace jointid::ident
