#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "minimise/gauss_newton.hpp"
#include "response/identify/fit_work.hpp"
#include "response/identify/law_unknowns.hpp"
#include "response/identify/state_model.hpp"

namespace jointid::response {

/// (value − prior)/deviation of the unknowns that have a prior.
minimise::Linearised prior_residuals(const LawUnknowns& unknowns, const Eigen::VectorXd& numbers);

/// (X − Y)/σ of all measured states over the unknown parameters of the joints. Rows: states in their order, of each the
/// harmonics, of each the responses, of each Re and Im (of the mean Re alone); then prior_residuals.
class ResponseResiduals {
 public:
  /// `harmonics`: of the model, see StateModel. The states must be valid.
  ResponseResiduals(std::shared_ptr<const Receptance> structure, const std::vector<MeasuredState>& states, LawUnknowns unknowns,
                    const std::vector<int>& harmonics, FitWork work = {});
  ResponseResiduals(std::vector<StateModel> models, LawUnknowns unknowns, FitWork work = {});

  const std::vector<StateModel>& models() const { return models_; }
  const LawUnknowns& unknowns() const { return unknowns_; }
  Eigen::Index rows() const { return rows_; }

  struct Value {
    minimise::Linearised linearised;  ///< Jacobian by the numbers of LawUnknowns
    std::vector<StatePrediction> states;
  };
  /// Nothing where a law makes no sense or harmonic balance does not converge. Starts at the motions of `last` if there are any.
  std::optional<Value> evaluate(const Eigen::VectorXd& numbers, const std::vector<StatePrediction>& last = {}) const;

 private:
  void fill(const StateModel& model, const StatePrediction& prediction, const Eigen::VectorXd& slopes, Eigen::Index& row,
            minimise::Linearised& linearised) const;

  std::vector<StateModel> models_;
  LawUnknowns unknowns_;
  Eigen::Index rows_ = 0;
  FitWork work_;
};

}  // namespace jointid::response
