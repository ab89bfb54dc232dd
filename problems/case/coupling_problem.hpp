#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "coupling/assembly.hpp"
#include "problems/case/problem_info.hpp"
#include "problems/case/problem_noise.hpp"
#include "problems/case/write_options.hpp"
#include "problems/structure/modes.hpp"

namespace jointid::problems {

/// A coupling problem with a known answer: FRFs of parts, what becomes of them, and the FRFs of the assembly, computed from its
/// own matrices.
struct CouplingProblem {
  std::string name;         ///< "coupling-C"
  std::string description;  ///< one line, with the thesis section
  std::vector<frf::FrfSet> parts;  ///< noise-free; header.file names them in the scene
  frf::FrfSet assembly;            ///< noise-free, at the coordinates of the result
  std::vector<std::array<frf::Dof, 2>> join;
  std::vector<frf::Dof> ground;
  std::string scene;  ///< TOML text for `jointid couple`
  ProblemNoise noise;
  std::vector<Modes> part_modes;
  Modes assembly_modes;

  /// The parts and conditions for jointid::coupling.
  coupling::Assembly declared() const;
};

/// Cases A, B and C of thesis §5.9.
std::vector<ProblemInfo> list_coupling();

/// Builds one; throws InputError (usage) with the nearest name of all built-in problems when there is none.
CouplingProblem make_coupling(const std::string& name);

/// Whether `name` is one of list_coupling().
bool is_coupling(const std::string& name);

/// The parts with the noise of the case; part i draws from stream (seed, trial, i).
std::vector<frf::FrfSet> polluted(const CouplingProblem& problem, std::uint64_t seed, std::uint64_t trial);

/// The sets as parts in memory, each its own system.
std::vector<coupling::Part> parts_of(const CouplingProblem& problem, const std::vector<frf::FrfSet>& sets);

/// Writes the parts, the exact assembly, NAME.toml and truth.json into `directory` and returns the scene's path.
std::filesystem::path write(const CouplingProblem& problem, const std::filesystem::path& directory, const WriteOptions& options);

}  // namespace jointid::problems
