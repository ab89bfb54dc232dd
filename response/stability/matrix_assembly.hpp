#pragma once

#include <vector>

#include "response/harmonic/excitation.hpp"
#include "response/harmonic/solution.hpp"
#include "response/joint/joint.hpp"
#include "response/orbit/periodic_orbit.hpp"
#include "response/structure/matrix_structure.hpp"

namespace jointid::response {

/// A structure by matrices with its joints and the places of its forces.
struct MatrixAssembly {
  MatrixStructure structure;
  Eigen::MatrixXd w;          ///< N × joints
  std::vector<Joint> joints;  ///< a joint each column
  Eigen::MatrixXd forces;     ///< N × forces
};

/// The forces times `level` at ω (rad/s) on the assembly.
PeriodicProblem periodic_problem(const MatrixAssembly& assembly, const Excitation& force, double omega, double level);

/// The motion of all coordinates by a solution of harmonic balance, X_n = H(nω)(P_n − WF_n), N × harmonics.
Eigen::MatrixXcd all_coordinates(const MatrixAssembly& assembly, const Excitation& force, const HarmonicSolution& solution);

}  // namespace jointid::response
