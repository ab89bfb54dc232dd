#pragma once

#include <filesystem>
#include <vector>

#include "frf/set/frf_set.hpp"
#include "models/matrix_value.hpp"
#include "models/modal_model.hpp"

namespace jointid::models {

/// Modes of a universal file with the DOFs and nodes that it has.
struct UffModes {
  Modes modes;
  std::vector<frf::Dof> dofs;  ///< of the coordinates
  std::vector<frf::Node> nodes;
};

/// Datasets 55: normal modes with modal masses, viscous or hysteretic damping, and complex modes with modal A; SI units. A DOF that
/// is 0 in every mode is one that the file has no data for and left out. Of complex modes those with Im λ < 0 are the conjugates of
/// others and left out. Throws InputError for modes of different DOFs, a modal mass that is not positive, a modal A of 0, and damping
/// below 0.
UffModes read_uff_modes(const std::filesystem::path& file);

/// Shapes [coordinate, mode], natural frequencies in Hz and modal masses (none named: 1) from variables of MATLAB or HDF5 files. A
/// square matrix of shapes has coordinates as rows in MATLAB, and in HDF5 of others as the first axis. Throws InputError where sizes
/// disagree.
Modes read_mode_arrays(const FileVariable& shapes, const FileVariable& frequencies, const FileVariable& masses);

}  // namespace jointid::models
