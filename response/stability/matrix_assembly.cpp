#include "response/stability/matrix_assembly.hpp"

#include "response/structure/matrix_receptance.hpp"
#include "response/time/from_joints.hpp"

namespace jointid::response {

PeriodicProblem periodic_problem(const MatrixAssembly& assembly, const Excitation& force, double omega, double level) {
  PeriodicProblem problem = {from_joints(assembly.structure, assembly.w, assembly.joints), omega, force.harmonics, {}};
  problem.amplitudes = level * assembly.forces * force.amplitudes.transpose();
  return problem;
}

Eigen::MatrixXcd all_coordinates(const MatrixAssembly& assembly, const Excitation& force, const HarmonicSolution& solution) {
  const Eigen::Index n = assembly.structure.mass.rows(), joints = assembly.w.cols();
  const MatrixReceptance receptance(assembly.structure, assembly.w, Eigen::MatrixXd::Identity(n, n), assembly.forces);
  Eigen::MatrixXcd x(n, at(solution.harmonics.size()));
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    const int harmonic = solution.harmonics[static_cast<std::size_t>(i)];
    Eigen::VectorXcd acting(joints + assembly.forces.cols());
    acting << -solution.joint_force.row(i).transpose(), solution.level * force.of(harmonic);
    x.col(i) = receptance.at(harmonic * solution.omega).bottomRows(n) * acting;
  }
  return x;
}

}  // namespace jointid::response
