#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "frf/set/frf_set.hpp"
#include "problems/case/problem_info.hpp"
#include "problems/case/write_options.hpp"

namespace jointid::problems {

/// A joint whose dynamic stiffness Z_J(ω) at every line is sought, or a substructure B to be decoupled, with the answer.
struct LineProblem {
  std::string name, description;
  std::vector<frf::FrfSet> substructures, assembly;  ///< noise-free; header.file names them in the scene
  std::string scene;                                 ///< TOML text for `jointid solve` or `jointid decouple`
  bool decouples = false;
  double noise = 0.01;           ///< circular, of every FRF
  std::vector<std::string> law;  ///< "K0 = 30000 N/m", of the joint
  /// Z of the joint, or H of B at the interface: upper triangle row by row, [lines][elements].
  std::vector<std::vector<Complex>> truth;
};

/// isolator, isolator-zener, decoupling-beams.
std::vector<ProblemInfo> list_line_problems();

/// Throws InputError (usage) with the nearest name where there is none.
LineProblem make_line_problem(const std::string& name);

/// With the noise of the problem, whose variances the sets tell.
LineProblem polluted(LineProblem problem, std::uint64_t seed);

/// Writes the files, NAME.toml and truth.json into `directory` and returns the scene's path.
std::filesystem::path write(const LineProblem& problem, const std::filesystem::path& directory, const WriteOptions& options);

}  // namespace jointid::problems
