#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "dense/ridge.hpp"
#include "minimise/gauss_newton.hpp"
#include "response/identify/state_model.hpp"

namespace jointid::response {

/// Errors of each line, in standard deviations: those of the receptances of its harmonics one after the other, two numbers for
/// each of Receptance::errors(), then those of the forces of its states, two numbers for each force.
using LineErrors = std::vector<Eigen::VectorXd>;

/// Which states and harmonics belong to the lines of a set of models.
class LineLayout {
 public:
  struct Harmonic {
    int number = 1;
    Eigen::Index first = 0, count = 0;  ///< of its errors in those of the line
  };
  struct Force {
    std::size_t state = 0;
    int number = 1;                     ///< of the harmonic
    Eigen::Index first = 0, count = 0;  ///< of its errors in those of the line
  };
  struct Line {
    double omega = 0.0;
    std::vector<std::size_t> states;
    std::vector<Eigen::Index> rows;  ///< of the residuals
    std::vector<Harmonic> harmonics;
    std::vector<Force> forces{};  ///< whose errors are known
    Eigen::Index errors = 0;
  };

  LineLayout(const std::vector<StateModel>& models, const Receptance& structure);

  const std::vector<Line>& lines() const { return lines_; }
  LineErrors no_errors() const;

 private:
  static void add_forces(std::size_t state, const StateModel& model, Line& line);

  std::vector<Line> lines_;
};

/// What errors of the receptances and of the forces do to the residuals: all levels of a line have the same H, so their residuals
/// are correlated. In deviations of the responses the covariance of a line is S = I + BBᵀ, B = [B_1 B_3 … B_P] of
/// ReceptanceResponse at nω. Lines are taken as independent: a receptance at 3ω that is also one at another line's ω counts
/// twice.
class LineCorrelation {
 public:
  /// Of no states yet; on as many threads. The layout is kept by reference.
  LineCorrelation(const LineLayout& layout, std::size_t threads);

  /// Of these states; memory of those before is used again.
  void set(const std::vector<StateModel>& models, const std::vector<StatePrediction>& states,
           const std::vector<JointForce>& joints);

  /// The residuals less what the errors do to them, r − Bu.
  Eigen::VectorXd without(const LineErrors& errors, const Eigen::VectorXd& residual) const;

  /// L⁻¹(r − Bu) and L⁻¹J of each line, LLᵀ = S, up to a rotation that leaves as few rows as there are numbers; then the rows that
  /// belong to no line.
  minimise::Linearised whitened(const Eigen::VectorXd& without, const Eigen::MatrixXd& jacobian) const;

  /// The errors v that minimise ‖r − Bu + Bv‖² + ‖v‖²: v = −BᵀS⁻¹(r − Bu), from r − Bu.
  LineErrors best_errors(const Eigen::VectorXd& without) const;

 private:
  const LineLayout* layout_;
  std::size_t threads_;
  std::vector<std::optional<dense::Ridge>> by_errors_;  ///< B of each line
};

}  // namespace jointid::response
