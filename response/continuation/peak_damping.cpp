#include "response/continuation/peak_damping.hpp"

#include <algorithm>
#include <cmath>

#include "dense/lu.hpp"

namespace jointid::response {
namespace {

/// 1/h at ω with forces `stiffness` · q in the joints.
Complex inverse_response(const Receptance& structure, double omega, const Eigen::VectorXcd& stiffness,
                         const Eigen::VectorXcd& force, Eigen::Index response) {
  const Eigen::MatrixXcd h = structure.at(omega);
  const Eigen::Index joints = structure.joints(), row = joints + response;
  const Eigen::MatrixXcd system =
      Eigen::MatrixXcd::Identity(joints, joints) + h.topLeftCorner(joints, joints) * stiffness.asDiagonal();
  const Eigen::VectorXcd driven = h.rightCols(structure.forces()) * force, q = dense::solve(system, driven.head(joints));
  return 1.0 / (driven(row) - (h.row(row).head(joints) * stiffness.asDiagonal() * q)(0));
}

}  // namespace

std::optional<PeakMode> peak_mode(const HarmonicBalance& balance, const HarmonicSolution& solution, Eigen::Index response,
                                  int harmonic, const std::array<double, 2>& beside) {
  const Eigen::VectorXcd force = balance.force().of(harmonic);
  const auto place = std::ranges::find(solution.harmonics, harmonic);
  if (force.isZero(0.0) || place == solution.harmonics.end()) return std::nullopt;
  const Eigen::Index n = place - solution.harmonics.begin();
  Eigen::VectorXcd stiffness(solution.joint_motion.cols()), dashpots(stiffness.size());
  for (Eigen::Index j = 0; j < stiffness.size(); ++j) {
    const Complex q = solution.joint_motion(n, j);
    dashpots(j) = balance.joints()[static_cast<std::size_t>(j)].damping;
    stiffness(j) =
        q == 0.0 ? Complex(balance.joints()[static_cast<std::size_t>(j)].stuck_stiffness()) : solution.joint_force(n, j) / q;
  }
  const double omega = harmonic * solution.omega, a = omega - beside[0], b = beside[1] - omega;
  const auto z = [&](double at) {
    return inverse_response(balance.structure(), at, stiffness + Complex(0.0, at - omega) * dashpots, force, response);
  };
  const Complex low = z(beside[0]), middle = z(omega), high = z(beside[1]);
  const Complex slope = ((high - middle) * a / b + (middle - low) * b / a) / (a + b), ratio = -middle / slope;
  const double decay = omega * ratio.imag() / (omega + ratio.real());  // ζω_r
  const double square = omega * omega + 2.0 * omega * ratio.real() + 2.0 * decay * ratio.imag();
  if (!(square > 0.0) || !(decay > 0.0)) return std::nullopt;
  return PeakMode{std::sqrt(square), decay / std::sqrt(square)};
}

}  // namespace jointid::response
