#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "frf/set/dof.hpp"

/// Readers of cards that know nothing of the writers: from the programs' manuals.
namespace jointid::cards {

/// Matrices over the DOFs asked for.
struct Assembled {
  Eigen::MatrixXd k, m, c, d;

  explicit Assembled(std::size_t n);
  Eigen::MatrixXcd impedance(double omega) const;
};

/// Of a bulk data deck of large fields: CELAS2, CDAMP2, CMASS2, CBUSH with PBUSH, DMIG that comments on the case control select.
Assembled read_nastran(const std::string& text, const std::vector<frf::Dof>& dofs);

/// ET, KEYOPT, R, RMORE, TYPE, REAL and EN of MATRIX27 and COMBIN14.
Assembled read_ansys(const std::string& text, const std::vector<frf::Dof>& dofs);

/// SPRING1, SPRING2, DASHPOT1, DASHPOT2, CONN3D2, *MATRIX INPUT with *MATRIX ASSEMBLE.
Assembled read_abaqus(const std::string& text, const std::vector<frf::Dof>& dofs);

/// Symmetric or general coordinates.
Eigen::MatrixXd read_market(const std::string& text);

}  // namespace jointid::cards
