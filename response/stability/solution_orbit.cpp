#include "response/stability/solution_orbit.hpp"

#include "response/fourier/joint_loop.hpp"
#include "response/time/from_joints.hpp"

namespace jointid::response {
namespace {

OrbitStart start_of(const MatrixAssembly& assembly, const Eigen::MatrixXcd& x, const HarmonicSolution& solution) {
  OrbitStart start = {x.rowwise().sum().real(), Eigen::VectorXd::Zero(x.rows()), {}, {}};
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    start.v -= solution.harmonics[static_cast<std::size_t>(i)] * solution.omega * x.col(i).imag();
  }
  const Harmonics harmonics(solution.harmonics);
  const std::vector<std::size_t> joints = friction_joints(assembly.joints);
  start.f.resize(at(joints.size()));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const PeriodicMemory memory =
        periodic_memory(*assembly.joints[joints[i]].friction, Motion(harmonics, solution.joint_motion.col(at(joints[i]))));
    start.f[at(i)] = memory.force;
    start.turns.push_back(memory.turns);
  }
  return start;
}

}  // namespace

SolutionStability stability(const MatrixAssembly& assembly, const Excitation& force, const HarmonicSolution& solution,
                            const OrbitOptions& options) {
  const PeriodicProblem problem = periodic_problem(assembly, force, solution.omega, solution.level);
  const Eigen::MatrixXcd x = all_coordinates(assembly, force, solution);
  const OrbitStart start = start_of(assembly, x, solution);
  SolutionStability found;
  found.orbit = find_orbit(problem, start, options);
  if (!found.orbit.closed) found.orbit = find_orbit(problem, options);
  if (!found.orbit.closed) return found;
  found.difference = (found.orbit.x - start.x).cwiseAbs().maxCoeff() / x.cwiseAbs().rowwise().sum().maxCoeff();
  const std::vector<std::size_t> joints = friction_joints(assembly.joints);
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (found.orbit.residual_force_free[i]) found.residual_force_free.push_back(joints[i]);
  }
  return found;
}

}  // namespace jointid::response
