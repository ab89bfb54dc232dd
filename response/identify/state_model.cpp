#include "response/identify/state_model.hpp"

#include <algorithm>
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

}  // namespace jointid::response
