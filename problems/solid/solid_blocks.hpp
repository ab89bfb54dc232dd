#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "frf/set/frf_set.hpp"
#include "models/structure_matrices.hpp"
#include "problems/case/problem_info.hpp"
#include "problems/case/write_options.hpp"

namespace jointid::problems {

/// A part as its finite-element matrices, and the coordinates that have a name.
struct SolidPart {
  std::string name;
  models::StructureMatrices matrices;
  std::vector<frf::Dof> dofs;
  std::vector<std::size_t> coordinates;  ///< of `dofs`
};

/// A bolt's stiffness in one direction between two DOFs.
struct SolidSpring {
  frf::Dof first, second;
  double stiffness = 0.0;  ///< N/m; k(1 + i·loss)
  double loss = 0.0;
};

/// Two free steel blocks of bricks (1,575 and 1,890 coordinates), bolted at the four corners of their ends: parts that are models, an
/// assembly that was measured. Noise 1 % circular.
struct SolidBlocks {
  std::string name, description;
  std::vector<SolidPart> parts;
  std::vector<SolidSpring> springs;
  frf::FrfSet assembly;  ///< noise-free
};

std::vector<ProblemInfo> list_solid_blocks();

SolidBlocks make_solid_blocks();

/// Writes the matrices as Matrix Market files, a description of each part, the assembly, solid-blocks.toml and truth.json into
/// `directory`, and returns the scene's path.
std::filesystem::path write(const SolidBlocks& problem, const std::filesystem::path& directory, const WriteOptions& options);

}  // namespace jointid::problems
