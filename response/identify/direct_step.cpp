#include "response/identify/direct_step.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "dense/svd.hpp"
#include "response/harmonic/harmonic_line.hpp"

namespace jointid::response {
namespace {

constexpr double least_separation = 1e-10;

/// (H_mW)⁺ with rows weighted, and σ_min/σ_max of the columns scaled to norm 1.
struct Inverse {
  Eigen::MatrixXcd to_forces;  ///< [joint, response]
  double separation = 0.0;
};

Inverse inverse_of(const Eigen::MatrixXcd& to_joints, const Eigen::VectorXd& deviation) {
  const Eigen::VectorXd weight = deviation.cwiseInverse();
  Eigen::MatrixXcd weighted = weight.asDiagonal() * to_joints;
  if (weighted.rows() < weighted.cols() || !(weighted.colwise().norm().minCoeff() > 0.0)) return {};
  const Eigen::VectorXd scale = weighted.colwise().norm().transpose().cwiseInverse();
  weighted = weighted * scale.asDiagonal();
  const dense::ComplexSvd svd = dense::jacobi_svd(weighted, dense::Vectors::thin, dense::Vectors::thin);
  const double separation = svd.sigma(svd.sigma.size() - 1) / svd.sigma(0);
  if (!(separation > least_separation)) return {{}, separation};
  return {scale.asDiagonal() * svd.v * svd.sigma.cwiseInverse().asDiagonal() * svd.u.adjoint() * weight.asDiagonal(), separation};
}

[[noreturn]] void fail_rank(const MeasuredState& state, int harmonic, Eigen::Index joints) {
  throw InputError(
      {.kind = ErrorKind::data,
       .file = "",
       .place = "harmonic " + std::to_string(harmonic) + " of " + std::to_string(state.omega) + " rad/s",
       .problem = std::to_string(state.response.cols()) + " responses do not separate the forces of " + std::to_string(joints) +
                  " joints: rank H_mW < " + std::to_string(joints),
       .remedy = "measure as many responses as there are joints at least, at places that the joints move differently"});
}

double squared(double x) { return x * x; }

/// Sums of squared real and imaginary parts of what independent errors change.
class Scatter {
 public:
  explicit Scatter(Eigen::Index joints) : force(Eigen::VectorXcd::Zero(joints)), motion(force), equivalent(force) {}

  /// δF and δQ of an error with this variance; `ratio` = F/Q, `motion` = Q.
  void add(const Eigen::VectorXcd& by_force, const Eigen::VectorXcd& by_motion, const Eigen::VectorXcd& ratio,
           const Eigen::VectorXcd& of_motion, double variance) {
    const auto squares = [variance](Complex v) { return variance * Complex(squared(v.real()), squared(v.imag())); };
    force += by_force.unaryExpr(squares);
    motion += by_motion.unaryExpr(squares);
    const Eigen::VectorXcd change = (by_force - ratio.cwiseProduct(by_motion)).cwiseQuotient(of_motion);
    equivalent += change.unaryExpr(squares);
  }

  Eigen::VectorXcd force, motion, equivalent;
};

Eigen::VectorXcd deviations_of(const Eigen::VectorXcd& variance) {
  return variance.unaryExpr([](Complex v) { return Complex(std::sqrt(v.real()), std::sqrt(v.imag())); });
}

/// One harmonic n, its mean (n = 0) having no imaginary part.
class OneHarmonic {
 public:
  OneHarmonic(const Receptance& structure, const MeasuredState& state, const HarmonicLine& line, Eigen::Index row)
      : structure_(structure),
        state_(state),
        row_(row),
        n_(state.harmonics[static_cast<std::size_t>(row)]),
        part_(line.harmonics[static_cast<std::size_t>(row)]),
        inverse_(inverse_of(part_.to_joints, state.deviation.row(row).transpose())) {
    if (inverse_.to_forces.size() == 0) fail_rank(state, n_, structure.joints());
    force = -inverse_.to_forces * (state.response.row(row).transpose() - part_.free);
    motion = part_.driven - part_.joints * force;
    equivalent = force.cwiseQuotient(motion);
  }

  double separation() const { return inverse_.separation; }

  Scatter scatter() const {
    Scatter sum(force.size());
    for (Eigen::Index r = 0; r < state_.response.cols(); ++r) {
      const double variance = squared(state_.deviation(row_, r));
      add(sum, -inverse_.to_forces.col(r), Eigen::VectorXcd::Zero(force.size()), variance, n_ == 0 ? 0.0 : variance);
    }
    Eigen::VectorXcd acting(force.size() + structure_.forces());
    acting << -force, state_.force.of(n_);
    for (const ReceptanceError& error : structure_.errors(n_ * state_.omega)) {
      const Eigen::VectorXcd moved = error.shape * acting;
      add(sum, inverse_.to_forces * moved.tail(structure_.responses()), moved.head(force.size()), error.variance.real(),
          error.variance.imag());
    }
    add_force_errors(sum);
    return sum;
  }

  Eigen::VectorXcd force, motion, equivalent;

 private:
  /// δF, and δQ = own − G δF, of an error whose real and imaginary part have these variances.
  void add(Scatter& sum, const Eigen::VectorXcd& by_force, const Eigen::VectorXcd& own, double real, double imaginary) const {
    const Eigen::VectorXcd by_motion = own - part_.joints * by_force;
    const Complex i(0.0, 1.0);
    sum.add(by_force, by_motion, equivalent, motion, real);
    sum.add(i * by_force, i * by_motion, equivalent, motion, imaginary);
  }

  void add_force_errors(Scatter& sum) const {
    const Eigen::Index row = state_.force.row(n_);
    if (n_ == 0 || row < 0 || !state_.knows_force_errors()) return;
    const Eigen::MatrixXcd by_force = structure_.at(n_ * state_.omega).rightCols(structure_.forces());
    for (Eigen::Index p = 0; p < by_force.cols(); ++p) {
      const double variance = squared(state_.force_deviation(row, p));
      add(sum, inverse_.to_forces * by_force.col(p).tail(structure_.responses()), by_force.col(p).head(structure_.joints()),
          variance, variance);
    }
  }

  const Receptance& structure_;
  const MeasuredState& state_;
  Eigen::Index row_;
  int n_;
  const HarmonicLine::One& part_;
  Inverse inverse_;
};

}  // namespace

DirectStep direct_step(const Receptance& structure, const MeasuredState& state) {
  require_valid({state}, structure);
  DirectStep step;
  step.omega = state.omega;
  step.harmonics = state.harmonics;
  const Eigen::Index rows = at(state.harmonics.size()), joints = structure.joints();
  step.joint_force.resize(rows, joints);
  step.joint_motion = step.force_deviation = step.motion_deviation = step.joint_force;
  const HarmonicLine line = harmonic_line(structure, Harmonics(state.harmonics), state.force, state.omega);
  for (Eigen::Index n = 0; n < rows; ++n) {
    const OneHarmonic one(structure, state, line, n);
    const Scatter scatter = one.scatter();
    step.joint_force.row(n) = one.force.transpose();
    step.joint_motion.row(n) = one.motion.transpose();
    step.force_deviation.row(n) = deviations_of(scatter.force).transpose();
    step.motion_deviation.row(n) = deviations_of(scatter.motion).transpose();
    step.separation = std::min(step.separation, one.separation());
    if (state.harmonics[static_cast<std::size_t>(n)] != 1) continue;
    step.equivalent = one.equivalent;
    step.equivalent_deviation = deviations_of(scatter.equivalent);
  }
  return step;
}

}  // namespace jointid::response
