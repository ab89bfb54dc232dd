#include "response/harmonic/deviations.hpp"

#include <cmath>

#include "dense/real_lu.hpp"
#include "response/harmonic/attempts.hpp"

namespace jointid::response {
namespace {

/// A power of two near the largest response: in its units squares of changes neither overflow nor vanish, and no digit changes.
double unit_of(const HarmonicSolution& solution) {
  const double largest = solution.response.size() == 0 ? 0.0 : solution.response.cwiseAbs().maxCoeff();
  return largest > 0.0 ? std::exp2(std::ilogb(largest)) : 1.0;
}

/// The linearised problem at a solution.
class Sensitivity {
 public:
  Sensitivity(const HarmonicBalance& balance, const HarmonicSolution& solution)
      : balance_(balance),
        solution_(solution),
        equations_(balance.joints(), Harmonics(solution.harmonics)),
        line_(harmonic_line(balance.structure(), equations_.harmonics(), balance.force(), solution.omega)),
        motion_(embedded(equations_, solution.harmonics, solution.joint_motion)),
        jacobian_(equations_.evaluate(line_, solution.level, motion_).by_motion),
        slopes_(equations_.forces_by_motion(solution.omega, motion_)),
        unit_(unit_of(solution)),
        variance_(Eigen::MatrixXcd::Zero(solution.response.rows(), solution.response.cols())),
        amplitude_variance_(Eigen::MatrixXd::Zero(variance_.rows(), variance_.cols())) {}

  /// One error of H at the n-th harmonic.
  void add(Eigen::Index n, const ReceptanceError& error) {
    const Eigen::Index joints = solution_.joint_force.cols(), forces = balance_.structure().forces();
    Eigen::VectorXcd acting(joints + forces);
    acting << -solution_.joint_force.row(n).transpose(), solution_.level * balance_.force().of(equations_.harmonics()[n]);
    const Eigen::VectorXcd moved = error.shape * acting;
    add_part(n, moved, error.variance.real());
    add_part(n, Complex(0.0, 1.0) * moved, error.variance.imag());
  }

  void add(const ParameterDeviation& parameter) {
    const Eigen::VectorXd by_parameter = equations_.by_parameter(line_, motion_, parameter.parameter);
    const Eigen::MatrixXcd own = parameter_forces(parameter.parameter);
    add_change(-jacobian_.solve(by_parameter), own, parameter.deviation * parameter.deviation);
  }

  ResponseDeviations deviations() const {
    const auto roots = [](Complex v) { return Complex(std::sqrt(v.real()), std::sqrt(v.imag())); };
    return {unit_ * variance_.unaryExpr(roots), unit_ * amplitude_variance_.cwiseSqrt()};
  }

 private:
  /// −HW ∂F/∂θ at the responses, [harmonic, response].
  Eigen::MatrixXcd parameter_forces(const JointParameter& parameter) const {
    const std::size_t j = parameter.joint;
    const Harmonics& harmonics = equations_.harmonics();
    const Motion motion(harmonics, solution_.joint_motion.col(at(j)));
    const ForceHarmonics force = equations_.joints()[j].evaluate(motion, line_.omega, harmonics, true);
    Eigen::MatrixXcd own(variance_.rows(), variance_.cols());
    for (Eigen::Index n = 0; n < own.rows(); ++n) {
      own.row(n) =
          -(line_.harmonics[static_cast<std::size_t>(n)].to_joints.col(at(j)) * force.by_parameters(n, at(parameter.parameter)))
               .transpose();
    }
    return own;
  }

  /// δu at the n-th harmonic: first at the joints, then at the responses.
  void add_part(Eigen::Index n, const Eigen::VectorXcd& moved, double variance) {
    const Eigen::Index joints = solution_.joint_force.cols();
    Eigen::MatrixXcd at_joints = Eigen::MatrixXcd::Zero(variance_.rows(), joints);
    Eigen::MatrixXcd own = Eigen::MatrixXcd::Zero(variance_.rows(), variance_.cols());
    at_joints.row(n) = moved.head(joints).transpose();
    own.row(n) = moved.tail(moved.size() - joints).transpose();
    add_change(jacobian_.solve(equations_.pack(at_joints)), own, variance);
  }

  /// δX = own − HW ∂F/∂Q δQ.
  void add_change(const Eigen::VectorXd& motion, const Eigen::MatrixXcd& own, double variance) {
    for (Eigen::Index n = 0; n < variance_.rows(); ++n) {
      const std::size_t at_n = static_cast<std::size_t>(n);
      const Eigen::VectorXcd change =
          (own.row(n).transpose() - line_.harmonics[at_n].to_joints * (slopes_[at_n] * motion)) / unit_;
      for (Eigen::Index r = 0; r < change.size(); ++r) {
        const bool mean = equations_.harmonics()[n] == 0;
        const Complex x = solution_.response(n, r), along = x == 0.0 ? 1.0 : x / std::abs(x);
        variance_(n, r) += variance * Complex(Eigen::numext::abs2(change(r).real()), mean ? 0.0 : Eigen::numext::abs2(change(r).imag()));
        amplitude_variance_(n, r) += variance * Eigen::numext::abs2(std::real(std::conj(along) * change(r)));
      }
    }
  }

  const HarmonicBalance& balance_;
  const HarmonicSolution& solution_;
  CondensedEquations equations_;
  HarmonicLine line_;
  Eigen::VectorXd motion_;
  dense::RealLu jacobian_;
  std::vector<Eigen::MatrixXcd> slopes_;
  double unit_;
  Eigen::MatrixXcd variance_;  ///< in its squares, as the next
  Eigen::MatrixXd amplitude_variance_;
};

}  // namespace

ResponseDeviations deviations(const HarmonicBalance& balance, const HarmonicSolution& solution,
                              const std::vector<ParameterDeviation>& parameters) {
  Sensitivity sensitivity(balance, solution);
  for (Eigen::Index n = 0; n < at(solution.harmonics.size()); ++n) {
    const double omega = solution.harmonics[static_cast<std::size_t>(n)] * solution.omega;
    for (const ReceptanceError& error : balance.structure().errors(omega)) sensitivity.add(n, error);
  }
  for (const ParameterDeviation& parameter : parameters) sensitivity.add(parameter);
  return sensitivity.deviations();
}

}  // namespace jointid::response
