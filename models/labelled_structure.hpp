#pragma once

#include <map>
#include <optional>
#include <string>

#include "models/model_dofs.hpp"
#include "models/structure_matrices.hpp"

namespace jointid::models {

/// M, K, C and D of a description, as its files order their rows.
struct LabelledStructure {
  StructureMatrices matrices;
  NamedCoordinates coordinates;  ///< by the files' labels; none: the files have none
};

/// Reads `mass`, `stiffness`, `viscous_damping` and `hysteretic_damping` of a table. Where files label their rows, these are the
/// union of all labels, and a row that a matrix does not have is 0 there; translations and rotations of labels are DOFs. A
/// complex stiffness is K + iD. Throws InputError for labels of some files alone, sizes that differ without labels, and matrices
/// that are complex otherwise.
LabelledStructure read_structure(const scene::Table& table, const std::filesystem::path& folder);

}  // namespace jointid::models
