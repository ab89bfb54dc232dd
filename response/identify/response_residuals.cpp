#include "response/identify/response_residuals.hpp"

#include <atomic>
#include <utility>

#include "base/control.hpp"
#include "base/parallel.hpp"

namespace jointid::response {
namespace {

std::vector<StateModel> models_of(const std::shared_ptr<const Receptance>& structure, const std::vector<MeasuredState>& states,
                                  const std::vector<int>& harmonics) {
  std::vector<StateModel> models;
  for (const MeasuredState& state : states) models.emplace_back(structure, state, harmonics);
  return models;
}

}  // namespace

minimise::Linearised prior_residuals(const LawUnknowns& unknowns, const Eigen::VectorXd& numbers) {
  const Eigen::VectorXd values = unknowns.values(numbers), slopes = unknowns.slopes(numbers);
  minimise::Linearised out = {Eigen::VectorXd(unknowns.priors()), Eigen::MatrixXd::Zero(unknowns.priors(), unknowns.size())};
  Eigen::Index row = 0;
  for (Eigen::Index i = 0; i < unknowns.size(); ++i) {
    const auto& prior = unknowns.unknown(i).prior;
    if (!prior) continue;
    const auto [mean, deviation] = *prior;
    out.residual(row) = (values(i) - mean) / deviation;
    out.jacobian(row++, i) = slopes(i) / deviation;
  }
  return out;
}

ResponseResiduals::ResponseResiduals(std::shared_ptr<const Receptance> structure, const std::vector<MeasuredState>& states,
                                     LawUnknowns unknowns, const std::vector<int>& harmonics, FitWork work)
    : ResponseResiduals(models_of(structure, states, harmonics), std::move(unknowns), std::move(work)) {}

ResponseResiduals::ResponseResiduals(std::vector<StateModel> models, LawUnknowns unknowns, FitWork work)
    : models_(std::move(models)), unknowns_(std::move(unknowns)), rows_(unknowns_.priors()), work_(std::move(work)) {
  for (const StateModel& model : models_) rows_ += measured_numbers(model.state());
}

std::optional<ResponseResiduals::Value> ResponseResiduals::evaluate(const Eigen::VectorXd& numbers,
                                                                    const std::vector<StatePrediction>& last) const {
  stop_if(work_.interrupted);
  const auto joints = unknowns_.at_numbers(numbers);
  if (!joints) return std::nullopt;
  Value value = {{Eigen::VectorXd::Zero(rows_), Eigen::MatrixXd::Zero(rows_, unknowns_.size())}, {}};
  const Eigen::VectorXd slopes = unknowns_.slopes(numbers);
  const std::vector<JointForce> forces = joint_forces(*joints);
  value.states.resize(models_.size());
  std::atomic<bool> failed = false;
  for_each_index(models_.size(), work_.threads, [&](std::size_t i) {
    if (failed) return;
    value.states[i] = models_[i].predict(forces, unknowns_.moved(), i < last.size() ? &last[i].solution : nullptr);
    if (!value.states[i].solution.converged) failed = true;
  });
  if (failed) return std::nullopt;
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < models_.size(); ++i) fill(models_[i], value.states[i], slopes, row, value.linearised);
  const minimise::Linearised priors = prior_residuals(unknowns_, numbers);
  value.linearised.residual.tail(priors.residual.size()) = priors.residual;
  value.linearised.jacobian.bottomRows(priors.residual.size()) = priors.jacobian;
  if (!value.linearised.residual.allFinite() || !value.linearised.jacobian.allFinite()) return std::nullopt;
  return value;
}

void ResponseResiduals::fill(const StateModel& model, const StatePrediction& prediction, const Eigen::VectorXd& slopes,
                             Eigen::Index& row, minimise::Linearised& linearised) const {
  const MeasuredState& state = model.state();
  const Eigen::Index count = measured_numbers(state);
  linearised.residual.segment(row, count) = in_deviations(state, prediction.response - state.response);
  for (std::size_t i = 0; i < unknowns_.moved().size(); ++i) {
    const Eigen::Index unknown = unknowns_.moved_by()[i];
    linearised.jacobian.col(unknown).segment(row, count) += slopes(unknown) * in_deviations(state, prediction.by_parameter[i]);
  }
  row += count;
}

}  // namespace jointid::response
