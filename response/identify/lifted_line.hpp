#pragma once

#include <Eigen/Core>
#include <vector>

#include "response/identify/gauss_newton.hpp"
#include "response/identify/lifted_state.hpp"
#include "response/identify/line_correlation.hpp"

namespace jointid::response {

/// Changes of the unknowns that belong to lines.
struct LiftedChange {
  std::vector<Eigen::MatrixXcd> force;  ///< of each state, [harmonic, joint]
  LineErrors errors;
};

/// The rows of all states and their unknowns to first order: of each line the errors u of its receptances and the joints' forces
/// F of its states are eliminated. With S = I + BBᵀ = LLᵀ, A = L⁻¹∂r/∂F = QR, what is left of r − Bu and of ∂r/∂θ is (I − QQᵀ)L⁻¹
/// of them.
class LiftedLines {
 public:
  LiftedLines(const LineLayout& layout, const std::vector<StateModel>& models, const LawUnknowns& unknowns,
              const Eigen::VectorXd& numbers, const std::vector<Eigen::MatrixXcd>& force, const LineErrors& errors,
              const std::vector<Eigen::VectorXd>& tolerance);

  /// Residuals over the numbers of the laws alone, priors last: what is left when forces and errors do their best.
  const Linearised& reduced() const { return reduced_; }
  /// Their sum of squares after a step of the numbers.
  double least(const Eigen::VectorXd& step) const { return (reduced_.residual + reduced_.jacobian * step).squaredNorm(); }
  /// What forces and errors do best after it.
  LiftedChange change(const Eigen::VectorXd& step) const;

 private:
  struct Line {
    Eigen::MatrixXd by_errors, lower;    ///< B, L
    Eigen::MatrixXd basis, triangle;     ///< Q, R
    Eigen::MatrixXd by_force;            ///< ∂r/∂F
    Eigen::VectorXd residual;            ///< r − Bu
    Eigen::MatrixXd by_parameter;        ///< ∂r/∂θ
    Eigen::MatrixXd whitened_parameter;  ///< L⁻¹∂r/∂θ
    Eigen::VectorXd whitened_residual;
  };
  void eliminate(Line& line) const;
  void append(const Line& line, Eigen::Index& row);

  const LineLayout& layout_;
  const LineErrors& errors_;
  std::vector<Line> lines_;
  std::vector<Harmonics> harmonics_;  ///< of each state
  Eigen::Index joints_ = 0;
  Linearised reduced_;
};

}  // namespace jointid::response
