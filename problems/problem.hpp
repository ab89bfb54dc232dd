#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "frf/frf_set.hpp"
#include "frf/noise.hpp"
#include "problems/modes.hpp"
#include "restrictions/joint_spec.hpp"

namespace jointid::problems {

/// The errors a case is defined with: of the FRFs, or of the modes from which they are regenerated.
using ProblemNoise = std::variant<frf::NoiseModel, ConsistentErrors>;

/// An unknown of the scene and its exact value, named as restrictions::build() names it ("K(1,2)", "D.a").
struct ExactUnknown {
  std::string name;
  double value = 0.0;
};

/// A problem with a known answer: noise-free and polluted FRFs, the scene that identifies it, and the truth.
struct Problem {
  std::string name;                        ///< "A1"
  std::string description;                 ///< one line, with the thesis section
  std::vector<frf::FrfSet> substructures;  ///< noise-free; their cross FRFs are zero by construction
  frf::FrfSet assembly;                    ///< noise-free
  std::string
      scene;  ///< TOML text; its [data] names the files that write() makes, its [truth] the exact matrices

  std::vector<frf::Dof> joint_dofs;
  std::map<restrictions::Kind, Matrix> truth;  ///< over joint_dofs; absent matrices are zero
  std::vector<ExactUnknown> unknowns;          ///< in the order of the scene
  ProblemNoise noise;
  std::vector<Modes> substructure_modes;  ///< all modes of the undamped parts
  Modes assembly_modes;
};

struct ProblemInfo {
  std::string name;
  std::string description;
};

/// All built-in problems in the order of the thesis.
std::vector<ProblemInfo> list();

/// Builds one; throws InputError (usage) with the nearest name when there is none.
Problem make(const std::string& name);

/// A set with the errors of a case; `exact` are the modes of its structure.
frf::FrfSet with_noise(const frf::FrfSet& clean, const Modes& exact, const ProblemNoise& noise, const RandomStream& stream);

/// FRFs as a test would have given them.
struct Measurement {
  std::vector<frf::FrfSet> substructures;
  frf::FrfSet assembly;
};

/// The problem's FRFs with the noise of the case. Substructure i draws from stream (seed, trial, i), the
/// assembly from (seed, trial, number of substructures). Rig problems, whose noise is that of a hammer test,
/// carry coherences.
Measurement polluted(const Problem& problem, std::uint64_t seed, std::uint64_t trial);

struct WriteOptions {
  std::string format = "h5";  ///< "h5" or "uff"
  std::uint64_t seed = 1;     ///< of the noise that the case is defined with
  bool clean = false;         ///< leave the noise out
};

/// Writes the FRF files, NAME.toml and truth.json into `directory` (made if absent) and returns the scene's
/// path. The noise is that of trial 0.
std::filesystem::path write(const Problem& problem, const std::filesystem::path& directory,
                            const WriteOptions& options);

}  // namespace jointid::problems
