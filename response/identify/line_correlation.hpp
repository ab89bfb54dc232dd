#pragma once

#include <vector>

#include "response/identify/gauss_newton.hpp"
#include "response/identify/state_model.hpp"

namespace jointid::response {

/// What errors of the receptances do to the residuals: all levels of a line have the same H, so their residuals are correlated.
/// In deviations of the responses the covariance of a line is I + Σ_n B_nB_nᵀ, B_n = StateModel::by_receptances at nω. Lines are
/// taken as independent: a receptance at 3ω that is also one at another line's ω counts twice.
class LineCorrelation {
 public:
  LineCorrelation(const std::vector<StateModel>& models, const std::vector<StatePrediction>& states,
                  const std::vector<Joint>& joints);

  /// L⁻¹ times the rows of each line, LLᵀ its covariance.
  void whiten(Linearised& linearised) const;

  double log_determinant() const;

 private:
  struct Line {
    double omega;
    std::vector<std::size_t> states;
    std::vector<Eigen::Index> rows;
    Eigen::MatrixXd lower;
  };
  std::vector<Line> lines_;
};

}  // namespace jointid::response
