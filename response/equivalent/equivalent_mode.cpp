#include "response/equivalent/equivalent_mode.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "base/eigen.hpp"
#include "base/error.hpp"
#include "dense/eigen.hpp"

namespace jointid::response {
namespace {

constexpr int most_iterations = 200;
constexpr double unchanged = 1e-12;

[[noreturn]] void refuse(std::string problem) {
  throw InputError(
      {.kind = ErrorKind::usage, .file = "", .place = "equivalent mode", .problem = std::move(problem), .remedy = ""});
}

}  // namespace

EquivalentJoint equivalent_joint(const Joint& joint, double amplitude, double omega) {
  EquivalentJoint at = {joint.stiffness + 0.75 * joint.cubic * amplitude * amplitude, omega * joint.damping};
  if (joint.friction) {
    at.stiffness += joint.friction->equivalent_stiffness(amplitude);
    at.damping += joint.friction->cycle_energy(amplitude) / (std::numbers::pi * amplitude * amplitude);
  }
  return at;
}

EquivalentMode equivalent_mode(const MatrixStructure& structure, const Eigen::MatrixXd& w, const std::vector<Joint>& joints,
                               Eigen::Index mode, std::size_t of, double amplitude) {
  if (mode < 0 || mode >= structure.mass.rows()) refuse("there is no mode " + std::to_string(mode + 1));
  if (of >= joints.size() || w.cols() != at(joints.size())) refuse("there is no joint " + std::to_string(of + 1));
  if (!(amplitude > 0.0)) refuse("the amplitude " + std::to_string(amplitude) + " is not above 0");
  EquivalentMode found;
  found.amplitude = amplitude;
  Eigen::VectorXd sizes = Eigen::VectorXd::Constant(w.cols(), amplitude);
  for (int i = 0; i < most_iterations && !found.converged; ++i) {
    found.joints.clear();
    Eigen::VectorXd stiffness(w.cols()), damping(w.cols());
    for (Eigen::Index j = 0; j < w.cols(); ++j) {
      found.joints.push_back(equivalent_joint(joints[static_cast<std::size_t>(j)], sizes(j), found.omega));
      stiffness(j) = found.joints.back().stiffness;
      damping(j) = found.joints.back().damping;
    }
    const dense::SymmetricEigen modes =
        dense::symmetric_eigen(structure.stiffness + w * stiffness.asDiagonal() * w.transpose(), structure.mass);
    const Eigen::VectorXd shape = modes.vectors.col(mode), relative = w.transpose() * shape;
    const double own = relative(at(of)), before = found.omega;
    if (std::abs(own) <= 1e-12 * shape.cwiseAbs().maxCoeff())
      refuse("joint " + std::to_string(of + 1) + " stands still in the mode");
    const Eigen::VectorXd next = (amplitude / std::abs(own) * relative.cwiseAbs()).cwiseMax(1e-12 * amplitude);
    found.omega = std::sqrt(std::max(0.0, modes.values(mode)));
    found.converged = i > 0 && ((next - sizes).cwiseAbs().array() <= unchanged * next.array()).all() &&
                      std::abs(found.omega - before) <= unchanged * found.omega;
    sizes = next;
    found.loss_factor_joints = (damping.array() * relative.array().square()).sum() / modes.values(mode);
    found.loss_factor_viscous = shape.dot(structure.damping * shape) / found.omega;
    found.motion = amplitude / own * shape;
  }
  return found;
}

}  // namespace jointid::response
