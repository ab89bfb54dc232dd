#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "frf/set/dof.hpp"
#include "ident/scene/scene.hpp"

namespace jointid::laws {

/// Phasors of one file: those of some DOFs over its lines.
struct Phasors {
  std::string file;
  std::vector<double> frequency_hz;
  Eigen::MatrixXcd values;    ///< [line, DOF]; NaN where not measured
  Eigen::MatrixXd variances;  ///< of real and imaginary part each, their mean; empty when the file says nothing
};

/// The responses of a file that an FRF file can be: displacements (m) of every line, or forces as the file has them. Its one
/// reference says nothing here.
std::vector<frf::Dof> phasor_dofs(const ident::DataFile& file);

/// Throws InputError (data) when the file has more than one reference, or lacks a DOF.
Phasors read_phasors(const ident::DataFile& file, const std::vector<frf::Dof>& dofs);

}  // namespace jointid::laws
