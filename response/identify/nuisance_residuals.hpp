#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "minimise/damping.hpp"
#include "response/identify/line_correlation.hpp"
#include "response/identify/response_residuals.hpp"

namespace jointid::response {

/// Residuals of the likelihood with the structure's receptances as unknowns of their own: the cost of some parameters θ is
/// min_u ‖X(θ, H + Σ u σ shape) − Y‖²/σ_a² + ‖u‖², all levels of a line sharing u. With S = I + BBᵀ at the minimum it is
/// ‖L⁻¹(r − Bu)‖², LLᵀ = S, and L⁻¹J has the derivative of the cost by θ (variable projection). Rows are turned (LineCorrelation).
class NuisanceResiduals {
 public:
  NuisanceResiduals(std::shared_ptr<const Receptance> structure, std::vector<MeasuredState> states, LawUnknowns unknowns,
                    std::vector<int> harmonics, FitWork work = {});

  const LineLayout& layout() const { return layout_; }
  /// Those found last, where the next evaluation begins; none at first.
  const LineErrors& errors() const { return errors_; }
  /// Of those errors.
  const std::vector<StatePrediction>& states() const { return states_found_; }
  void begin_with(LineErrors errors) { errors_ = std::move(errors); }

  /// The cost of these numbers. Nothing where a law makes no sense or harmonic balance does not converge. Begins with the errors found
  /// last.
  std::optional<minimise::Linearised> evaluate(const Eigen::VectorXd& numbers, const std::vector<StatePrediction>& last = {});

  /// Its minimum over the numbers: Gauss–Newton steps of numbers and errors together, as gauss_newton takes them.
  minimise::GaussNewtonResult fit(const Eigen::VectorXd& start, const std::vector<StatePrediction>& last,
                                  const minimise::GaussNewtonOptions& options);

 private:
  /// Models, residuals and cost of some numbers and errors.
  struct Trial {
    Eigen::VectorXd numbers;
    LineErrors errors;
    ResponseResiduals residuals;
    ResponseResiduals::Value value;
    double cost = 0.0;
  };
  /// What a trial says to first order.
  struct FirstOrder {
    LineCorrelation correlation;
    Eigen::VectorXd without;  ///< r − Bu
    minimise::Linearised reduced;  ///< over the numbers
  };
  std::optional<Trial> tried(LineErrors errors, const Eigen::VectorXd& numbers, const std::vector<StatePrediction>& last) const;
  FirstOrder nothing() const { return {{layout_, work_.threads}, {}, {}}; }
  void linearise(const Trial& trial, FirstOrder& at) const;
  /// The best errors after a step of the numbers.
  LineErrors best_errors(const FirstOrder& at, const Trial& trial, const Eigen::VectorXd& step) const;
  /// A share of a step, and of the way to these errors.
  std::optional<Trial> moved(const Trial& trial, const Eigen::VectorXd& step, const LineErrors& best, double share) const;
  /// Goes to one with a lower cost; false when there is none.
  bool descend(const FirstOrder& at, Trial& trial, minimise::Damping& damping) const;
  bool settle(const LineErrors& best, Trial& trial) const;
  void keep(Trial&& trial);

  std::shared_ptr<const Receptance> structure_;
  std::vector<MeasuredState> states_;
  LawUnknowns unknowns_;
  std::vector<int> harmonics_;
  FitWork work_;
  LineLayout layout_;
  LineErrors errors_;
  std::vector<StatePrediction> states_found_;
};

}  // namespace jointid::response
