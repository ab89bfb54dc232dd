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

Eigen::MatrixXd StateModel::force_shares(int harmonic) const {
  const Eigen::Index row = state_.force.row(harmonic), forces = structure_->forces();
  const Eigen::MatrixXcd by_force = structure_->at(harmonic * state_.omega).rightCols(forces);
  Eigen::MatrixXd shares(2 * by_force.rows(), 2 * forces);
  for (Eigen::Index p = 0; p < forces; ++p) {
    for (Eigen::Index k = 0; k < by_force.rows(); ++k) {
      const Complex moved = state_.force_deviation(row, p) * by_force(k, p);
      shares.block<2, 2>(2 * k, 2 * p) << moved.real(), -moved.imag(), moved.imag(), moved.real();
    }
  }
  return shares;
}

StatePrediction StateModel::predict(const std::vector<JointForce>& joints, const std::vector<JointParameter>& parameters,
                                    const HarmonicSolution* last) const {
  const CondensedEquations equations(joints, harmonics_);
  const Attempt attempt = attempt_all(equations, line_, 1.0, last);
  StatePrediction prediction;
  prediction.forces = equations.joint_forces(line_.omega, attempt.result.motion, true);
  Eigen::MatrixXcd force(harmonics_.size(), at(joints.size()));
  for (std::size_t j = 0; j < joints.size(); ++j) force.col(at(j)) = prediction.forces[j].force;
  prediction.solution = described(equations, line_, 1.0, attempt.result.motion, std::move(force));
  prediction.solution.converged = attempt.result.converged;
  prediction.solution.residual = attempt.result.residual;
  prediction.solution.start = attempt.start;
  prediction.solution.steps = attempt.steps;
  if (!attempt.result.converged) return prediction;
  prediction.response = measured(prediction.solution.response);
  differentiate(equations, attempt.result.motion, parameters, prediction);
  return prediction;
}

Eigen::MatrixXcd StateModel::by_motion(const CondensedEquations& equations, Eigen::Index harmonic,
                                       const std::vector<ForceHarmonics>& forces) const {
  const Eigen::Index size = harmonics_.unknowns();
  const Eigen::MatrixXcd& to_joints = line_.harmonics[static_cast<std::size_t>(harmonic)].to_joints;
  Eigen::MatrixXcd moved(to_joints.rows(), equations.unknowns());
  for (Eigen::Index j = 0; j < to_joints.cols(); ++j)
    moved.middleCols(j * size, size) = -to_joints.col(j) * forces[static_cast<std::size_t>(j)].by_motion.row(harmonic);
  return moved;
}

void StateModel::differentiate(const CondensedEquations& equations, const Eigen::VectorXd& motion,
                               const std::vector<JointParameter>& parameters, StatePrediction& prediction) const {
  const dense::RealLu jacobian(equations.evaluate(line_, 1.0, motion, prediction.forces).by_motion);
  Eigen::MatrixXd change(motion.size(), at(parameters.size()));
  const auto force = [&](std::size_t i) {
    return prediction.forces[parameters[i].joint].by_parameters.col(at(parameters[i].parameter));
  };
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    Eigen::MatrixXcd at_joints(harmonics_.size(), prediction.solution.joint_motion.cols());
    for (Eigen::Index n = 0; n < harmonics_.size(); ++n) {
      const Eigen::MatrixXcd& g = line_.harmonics[static_cast<std::size_t>(n)].joints;
      at_joints.row(n) = (g.col(at(parameters[i].joint)) * force(i)(n)).transpose();
    }
    change.col(at(i)) = equations.pack(at_joints);
  }
  if (!parameters.empty()) change = -jacobian.solve(change).eval();
  prediction.by_parameter.assign(parameters.size(), Eigen::MatrixXcd::Zero(prediction.response.rows(), prediction.response.cols()));
  for (Eigen::Index m = 0; m < prediction.response.rows(); ++m) {
    const Eigen::Index n = harmonics_.find(state_.harmonics[static_cast<std::size_t>(m)]);
    const Eigen::MatrixXcd moved = by_motion(equations, n, prediction.forces) * change;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const auto own = line_.harmonics[static_cast<std::size_t>(n)].to_joints.col(at(parameters[i].joint));
      prediction.by_parameter[i].row(m) = (moved.col(at(i)) - own * force(i)(n)).transpose();
    }
  }
}

ReceptanceResponse::ReceptanceResponse(const StateModel& model, const std::vector<JointForce>& joints,
                                       const StatePrediction& prediction)
    : model_(model), prediction_(prediction) {
  const CondensedEquations equations(joints, model.harmonics_);
  const Eigen::VectorXd motion = equations.pack(prediction.solution.joint_motion);
  const dense::RealLu jacobian(equations.evaluate(model.line_, 1.0, motion, prediction.forces).by_motion);
  const Eigen::MatrixXd inverse = jacobian.solve(Eigen::MatrixXd::Identity(motion.size(), motion.size()));
  by_joints_ = Eigen::MatrixXd::Zero(measured_numbers(model.state_), motion.size());
  for (const int number : model.state_.harmonics) {
    const Eigen::MatrixXcd moved = model.by_motion(equations, model.harmonics_.find(number), prediction.forces) * inverse;
    Eigen::MatrixXd parts(2 * moved.rows(), moved.cols());
    for (Eigen::Index r = 0; r < moved.rows(); ++r) parts.middleRows(2 * r, 2) << moved.row(r).real(), moved.row(r).imag();
    add_in_deviations(model.state_, number, parts, by_joints_);
  }
}

Eigen::MatrixXd ReceptanceResponse::by_errors(int harmonic) const {
  const Eigen::Index n = model_.harmonics_.find(harmonic);
  return by_shares(harmonic, model_.error_shares(harmonic, prediction_.solution.joint_force.row(n).transpose()));
}

Eigen::MatrixXd ReceptanceResponse::by_forces(int harmonic) const { return by_shares(harmonic, model_.force_shares(harmonic)); }

Eigen::MatrixXd ReceptanceResponse::by_shares(int harmonic, const Eigen::MatrixXd& shares) const {
  const Harmonics& harmonics = model_.harmonics_;
  const Eigen::Index n = harmonics.find(harmonic), joints = model_.structure_->joints(), parts = harmonic > 0 ? 2 : 1;
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(by_joints_.rows(), shares.cols());
  for (Eigen::Index j = 0; j < joints; ++j) {
    columns += by_joints_.middleCols(j * harmonics.unknowns() + harmonics.offset(n), parts) * shares.middleRows(2 * j, parts);
  }
  add_in_deviations(model_.state_, harmonic, shares.bottomRows(shares.rows() - 2 * joints), columns);
  return columns;
}

}  // namespace jointid::response
