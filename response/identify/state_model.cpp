#include "response/identify/state_model.hpp"

#include <cmath>
#include <set>
#include <utility>

#include "dense/real_lu.hpp"
#include "response/harmonic/attempts.hpp"

namespace jointid::response {
namespace {

Harmonics model_harmonics(const Receptance& structure, const MeasuredState& state, const std::vector<int>& harmonics) {
  std::set<int> numbers(state.harmonics.begin(), state.harmonics.end());
  for (const int n : harmonics) {
    if (structure.covers(n * state.omega)) numbers.insert(n);
  }
  return Harmonics({numbers.begin(), numbers.end()});
}

}  // namespace

StateModel::StateModel(std::shared_ptr<const Receptance> structure, const MeasuredState& state, const std::vector<int>& harmonics)
    : structure_(std::move(structure)),
      state_(state),
      harmonics_(model_harmonics(*structure_, state, harmonics)),
      line_(harmonic_line(*structure_, harmonics_, state.force, state.omega)) {}

Eigen::MatrixXcd StateModel::measured(const Eigen::MatrixXcd& of_model) const {
  Eigen::MatrixXcd rows(at(state_.harmonics.size()), of_model.cols());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    rows.row(i) = of_model.row(harmonics_.find(state_.harmonics[static_cast<std::size_t>(i)]));
  }
  return rows;
}

Eigen::MatrixXd StateModel::error_shares(int harmonic, const Eigen::VectorXcd& joint_force) const {
  Eigen::VectorXcd acting(joint_force.size() + structure_->forces());
  acting << -joint_force, state_.force.of(harmonic);
  const std::vector<ReceptanceError> errors = structure_->errors(harmonic * state_.omega);
  Eigen::MatrixXd shares(2 * (structure_->joints() + structure_->responses()), 2 * at(errors.size()));
  for (std::size_t e = 0; e < errors.size(); ++e) {
    const Eigen::VectorXcd moved = errors[e].shape * acting;
    const double re = std::sqrt(errors[e].variance.real()), im = std::sqrt(errors[e].variance.imag());
    for (Eigen::Index k = 0; k < moved.size(); ++k) {
      shares.block<2, 1>(2 * k, 2 * at(e)) << re * moved(k).real(), re * moved(k).imag();
      shares.block<2, 1>(2 * k, 2 * at(e) + 1) << -im * moved(k).imag(), im * moved(k).real();
    }
  }
  return shares;
}

StatePrediction StateModel::predict(const std::vector<Joint>& joints, const std::vector<JointParameter>& parameters,
                                    const HarmonicSolution* last) const {
  const HarmonicBalance balance(structure_, joints, state_.force, {.fixed = harmonics_.numbers()});
  const CondensedEquations equations(joints, harmonics_);
  const Attempt attempt = attempt_all(equations, line_, 1.0, last);
  StatePrediction prediction;
  prediction.solution = balance.describe(equations, line_, 1.0, attempt.result.motion);
  prediction.solution.converged = attempt.result.converged;
  prediction.solution.residual = attempt.result.residual;
  prediction.solution.start = attempt.start;
  prediction.solution.steps = attempt.steps;
  if (!attempt.result.converged) return prediction;
  prediction.response = measured(prediction.solution.response);
  differentiate(equations, attempt.result.motion, parameters, prediction);
  return prediction;
}

void StateModel::differentiate(const CondensedEquations& equations, const Eigen::VectorXd& motion,
                               const std::vector<JointParameter>& parameters, StatePrediction& prediction) const {
  const HarmonicSolution& solution = prediction.solution;
  const dense::RealLu jacobian(equations.evaluate(line_, 1.0, motion).by_motion);
  const std::vector<Eigen::MatrixXcd> slopes = equations.forces_by_motion(line_.omega, motion);
  std::vector<ForceHarmonics> forces;
  for (std::size_t j = 0; j < equations.joints().size(); ++j) {
    const Motion own(harmonics_, solution.joint_motion.col(at(j)));
    forces.push_back(equations.joints()[j].evaluate(own, line_.omega, harmonics_, true));
  }
  for (const JointParameter& parameter : parameters) {
    const Eigen::Index j = at(parameter.joint);
    const Eigen::VectorXcd force = forces[parameter.joint].by_parameters.col(at(parameter.parameter));
    Eigen::MatrixXcd at_joints(harmonics_.size(), solution.joint_motion.cols());
    for (Eigen::Index n = 0; n < harmonics_.size(); ++n) {
      at_joints.row(n) = (line_.harmonics[static_cast<std::size_t>(n)].joints.col(j) * force(n)).transpose();
    }
    const Eigen::VectorXd change = -jacobian.solve(equations.pack(at_joints));
    Eigen::MatrixXcd response(harmonics_.size(), solution.response.cols());
    for (Eigen::Index n = 0; n < harmonics_.size(); ++n) {
      const std::size_t at_n = static_cast<std::size_t>(n);
      Eigen::VectorXcd total = slopes[at_n] * change;
      total(j) += force(n);
      response.row(n) = -(line_.harmonics[at_n].to_joints * total).transpose();
    }
    prediction.by_parameter.push_back(measured(response));
  }
}

ReceptanceResponse::ReceptanceResponse(const StateModel& model, const std::vector<Joint>& joints,
                                       const StatePrediction& prediction)
    : model_(model), prediction_(prediction), equations_(joints, model.harmonics_) {
  const Eigen::VectorXd motion = equations_.pack(prediction.solution.joint_motion);
  const dense::RealLu jacobian(equations_.evaluate(model.line_, 1.0, motion).by_motion);
  inverse_ = jacobian.solve(Eigen::MatrixXd::Identity(motion.size(), motion.size()));
  slopes_ = equations_.forces_by_motion(model.line_.omega, motion);
}

Eigen::MatrixXd ReceptanceResponse::by_motion(Eigen::Index harmonic) const {
  const Harmonics& harmonics = model_.harmonics_;
  const Eigen::Index joints = model_.structure_->joints(), responses = model_.structure_->responses();
  Eigen::MatrixXd columns(measured_numbers(model_.state_), 2 * (joints + responses));
  for (Eigen::Index k = 0; k < columns.cols(); ++k) {
    const Complex unit = k % 2 == 0 ? Complex(1.0) : Complex(0.0, 1.0);
    Eigen::MatrixXcd response = Eigen::MatrixXcd::Zero(harmonics.size(), responses);
    if (k / 2 < joints) {
      Eigen::MatrixXcd at_joints = Eigen::MatrixXcd::Zero(harmonics.size(), joints);
      at_joints(harmonic, k / 2) = unit;
      const Eigen::VectorXd moved = inverse_ * equations_.pack(at_joints);
      for (Eigen::Index m = 0; m < harmonics.size(); ++m) {
        const std::size_t at_m = static_cast<std::size_t>(m);
        response.row(m) = -(model_.line_.harmonics[at_m].to_joints * (slopes_[at_m] * moved)).transpose();
      }
    } else {
      response(harmonic, k / 2 - joints) = unit;
    }
    columns.col(k) = in_deviations(model_.state_, model_.measured(response));
  }
  return columns;
}

Eigen::MatrixXd ReceptanceResponse::by_errors(int harmonic) const {
  const Eigen::Index n = model_.harmonics_.find(harmonic);
  return by_motion(n) * model_.error_shares(harmonic, prediction_.solution.joint_force.row(n).transpose());
}

}  // namespace jointid::response
