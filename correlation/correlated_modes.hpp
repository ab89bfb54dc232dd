#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "frf/uff/uff55.hpp"

namespace jointid::correlation {

/// Modes of one file.
struct ModeFile {
  std::string file;  ///< for messages
  std::vector<frf::Uff55Mode> modes;
};

/// How the modes of two files agree over the coordinates that all of them have.
struct CorrelatedModes {
  std::vector<frf::Dof> dofs;                       ///< as in the first file
  std::vector<double> one_hz, other_hz;             ///< of all modes
  Eigen::MatrixXd mac;                              ///< [mode of the first, mode of the other]
  std::vector<std::optional<std::size_t>> partner;  ///< of each mode of the first, with a MAC of one half at least
  Eigen::VectorXd comac, ecomac;                    ///< of the pairs, of unit length, over `dofs`; empty without pairs

  std::size_t pairs() const;
};

/// Throws InputError (data) where a file has no mode, or there is no coordinate that all modes have.
CorrelatedModes correlate(const ModeFile& one, const ModeFile& other);

/// Shapes [dof × mode] at some coordinates that all modes have.
Eigen::MatrixXcd shapes_at(const std::vector<frf::Uff55Mode>& modes, const std::vector<frf::Dof>& dofs);

/// Coordinates that all modes of a file have, as in its first. Those where no mode moves are left out: dataset 55 fills up directions
/// that were not measured with zeros.
std::vector<frf::Dof> dofs_of_all(const ModeFile& of);

}  // namespace jointid::correlation
