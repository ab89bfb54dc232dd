#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "frf/set/frf_set.hpp"
#include "problems/case/problem_noise.hpp"
#include "problems/case/write_options.hpp"
#include "problems/structure/modes.hpp"
#include "restrictions/joint_spec.hpp"

namespace jointid::problems {

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

/// FRFs as a test would have given them.
struct Measurement {
  std::vector<frf::FrfSet> substructures;
  frf::FrfSet assembly;
};

/// The problem's FRFs with the noise of the case. Substructure i draws from stream (seed, trial, i), the
/// assembly from (seed, trial, number of substructures). Rig problems, whose noise is that of a hammer test,
/// carry coherences.
Measurement polluted(const Problem& problem, std::uint64_t seed, std::uint64_t trial);

/// Writes the FRF files, NAME.toml and truth.json into `directory` (made if absent) and returns the scene's
/// path. The noise is that of trial 0.
std::filesystem::path write(const Problem& problem, const std::filesystem::path& directory,
                            const WriteOptions& options);

}  // namespace jointid::problems
