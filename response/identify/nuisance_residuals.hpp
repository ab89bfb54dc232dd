#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "response/identify/line_correlation.hpp"
#include "response/identify/response_residuals.hpp"

namespace jointid::response {

/// Residuals of the likelihood with the structure's receptances as unknowns of their own: the cost of some parameters θ is
/// min_u ‖X(θ, H + Σ u σ shape) − Y‖²/σ_a² + ‖u‖², all levels of a line sharing u. With S = I + BBᵀ at the minimum it is
/// ‖L⁻¹(r − Bu)‖², LLᵀ = S, and L⁻¹J has the derivative of the cost by θ (variable projection).
class NuisanceResiduals {
 public:
  NuisanceResiduals(std::shared_ptr<const Receptance> structure, std::vector<MeasuredState> states, LawUnknowns unknowns,
                    std::vector<int> harmonics);

  const LineLayout& layout() const { return layout_; }
  /// Those found last, where the next evaluation begins; none at first.
  const LineErrors& errors() const { return errors_; }
  void begin_with(LineErrors errors) { errors_ = std::move(errors); }

  /// Nothing where a law makes no sense or harmonic balance does not converge. Begins with the errors found last.
  std::optional<ResponseResiduals::Value> evaluate(const Eigen::VectorXd& numbers, const std::vector<StatePrediction>& last = {});

 private:
  /// Models, residuals and cost of some errors.
  struct Trial {
    ResponseResiduals residuals;
    ResponseResiduals::Value value;
    double cost = 0.0;
  };
  std::optional<Trial> tried(const LineErrors& errors, const Eigen::VectorXd& numbers,
                             const std::vector<StatePrediction>& last) const;
  /// The errors moved towards `best` until the cost is lower; false when it does not fall.
  bool move(const LineErrors& best, const Eigen::VectorXd& numbers, LineErrors& errors, Trial& trial) const;

  std::shared_ptr<const Receptance> structure_;
  std::vector<MeasuredState> states_;
  LawUnknowns unknowns_;
  std::vector<int> harmonics_;
  LineLayout layout_;
  LineErrors errors_;
};

}  // namespace jointid::response
