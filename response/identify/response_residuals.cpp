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
  if (!value.linearised.residual.allFinite() || !value.linearised.jacobian.allFinite()) return std::nullopt;
  return value;
}

void ResponseResiduals::fill(const StateModel& model, const StatePrediction& prediction, const Eigen::VectorXd& slopes,
                             Eigen::Index& row, Linearised& linearised) const {
  const MeasuredState& state = model.state();
  const auto put = [&](Eigen::Index n, Eigen::Index r, auto part) {
    const double deviation = state.deviation(n, r);
    linearised.residual(row) = part(prediction.response(n, r) - state.response(n, r)) / deviation;
    for (Eigen::Index i = 0; i < slopes.size(); ++i) {
      linearised.jacobian(row, i) = part(prediction.by_parameter[static_cast<std::size_t>(i)](n, r)) * slopes(i) / deviation;
    }
    ++row;
  };
  for (Eigen::Index n = 0; n < state.response.rows(); ++n) {
    for (Eigen::Index r = 0; r < state.response.cols(); ++r) {
      put(n, r, [](Complex v) { return v.real(); });
      if (state.harmonics[static_cast<std::size_t>(n)] > 0) put(n, r, [](Complex v) { return v.imag(); });
    }
  }
}

}  // namespace jointid::response
