#include "response/identify/response_residuals.hpp"

#include <utility>

namespace jointid::response {
ResponseResiduals::ResponseResiduals(std::shared_ptr<const Receptance> structure, const std::vector<MeasuredState>& states,
                                     LawUnknowns unknowns, const std::vector<int>& harmonics)
    : unknowns_(std::move(unknowns)), rows_(measured_numbers(states)) {
  for (const MeasuredState& state : states) models_.emplace_back(structure, state, harmonics);
}

std::optional<ResponseResiduals::Value> ResponseResiduals::evaluate(const Eigen::VectorXd& numbers,
                                                                    const std::vector<StatePrediction>& last) const {
  const auto joints = unknowns_.at_numbers(numbers);
  if (!joints) return std::nullopt;
  Value value = {{Eigen::VectorXd(rows_), Eigen::MatrixXd(rows_, unknowns_.size())}, {}};
  const Eigen::VectorXd slopes = unknowns_.slopes(numbers);
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < models_.size(); ++i) {
    const HarmonicSolution* start = i < last.size() ? &last[i].solution : nullptr;
    value.states.push_back(models_[i].predict(*joints, unknowns_.free(), start));
    if (!value.states.back().solution.converged) return std::nullopt;
    fill(models_[i], value.states.back(), slopes, row, value.linearised);
  }
  if (correlation_) correlation_->whiten(value.linearised);
  if (!value.linearised.residual.allFinite() || !value.linearised.jacobian.allFinite()) return std::nullopt;
  return value;
}

void ResponseResiduals::weigh(const Value& value, const Eigen::VectorXd& numbers) {
  correlation_.emplace(models_, value.states, *unknowns_.at_numbers(numbers));
}

void ResponseResiduals::fill(const StateModel& model, const StatePrediction& prediction, const Eigen::VectorXd& slopes,
                             Eigen::Index& row, Linearised& linearised) const {
  const MeasuredState& state = model.state();
  const Eigen::Index count = measured_numbers(state);
  linearised.residual.segment(row, count) = in_deviations(state, prediction.response - state.response);
  for (Eigen::Index i = 0; i < slopes.size(); ++i) {
    linearised.jacobian.col(i).segment(row, count) =
        slopes(i) * in_deviations(state, prediction.by_parameter[static_cast<std::size_t>(i)]);
  }
  row += count;
}

}  // namespace jointid::response
