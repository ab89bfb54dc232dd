#pragma once

#include <cstddef>
#include <vector>

#include "frf/set/dof.hpp"

namespace jointid::ident {

/// Between which sensors of a table [[data.gains]] or [[data.masses]] an error is one.
enum class Sharing {
  files,  ///< a sensor stayed at its DOF from file to file: one per DOF
  none,   ///< one per DOF and file
  all     ///< one sensor (hammer) for all DOFs and files
};

/// The files of a table, by their numbers in DataSection.
struct ErrorFiles {
  std::vector<std::size_t> substructures, assembly;
};

/// Normal priors of gains, delays or angles of sensors: true FRF = gain · e^{iωτ} · (FRF of the file − Σ α · that of another direction at
/// the node).
struct GainPrior {
  std::vector<frf::Dof> dofs;  ///< empty: all of the files
  ErrorFiles files;
  bool of_reference = false;  ///< of hammer or shaker
  double gain = 0.0;          ///< standard deviation about 1; 0: known
  double delay = 0.0;         ///< s, about 0; 0: known
  double angle = 0.0;         ///< rad, about 0, towards every other translation at the node; 0: known
  Sharing shared = Sharing::files;
};

/// Masses of roving sensors, beside what is removed as known (frf::Corrections).
struct MassPrior {
  std::vector<frf::Dof> dofs;
  ErrorFiles files;
  double mass = 0.0;       ///< kg (kg·m² at a rotation), removed
  double deviation = 0.0;  ///< > 0
  Sharing shared = Sharing::files;
};

}  // namespace jointid::ident
