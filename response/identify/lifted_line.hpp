#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "dense/qr.hpp"
#include "dense/ridge.hpp"
#include "minimise/gauss_newton.hpp"
#include "response/identify/lifted_state.hpp"
#include "response/identify/line_correlation.hpp"

namespace jointid::response {

/// Changes of the unknowns that belong to lines.
struct LiftedChange {
  std::vector<Eigen::MatrixXcd> force;  ///< of each state, [harmonic, joint]
  LineErrors errors;
};

/// The rows of all states and their unknowns to first order. Of each state the joints' forces F are eliminated by a QR
/// decomposition of ∂r/∂F, then of each line the errors u of its receptances (dense::Ridge).
class LiftedLines {
 public:
  /// Of no states yet; on as many threads. Layout and unknowns are kept by reference.
  LiftedLines(const LineLayout& layout, const LawUnknowns& unknowns, std::size_t threads);

  /// At these states; memory of those before is used again.
  void set(const std::vector<StateModel>& models, const Eigen::VectorXd& numbers, const std::vector<Eigen::MatrixXcd>& force,
           const LineErrors& errors, const std::vector<Eigen::VectorXd>& tolerance);

  /// Residuals over the numbers of the laws alone, priors last: what is left when forces and errors do their best.
  const minimise::Linearised& reduced() const { return reduced_; }
  /// Their sum of squares after a step of the numbers.
  double least(const Eigen::VectorXd& step) const { return (reduced_.residual + reduced_.jacobian * step).squaredNorm(); }
  /// What forces and errors do best after it.
  LiftedChange change(const Eigen::VectorXd& step) const;

 private:
  struct Line {
    std::vector<dense::Elimination> states;  ///< F from [∂r/∂u, ∂r/∂θ, r − (∂r/∂u)u]
    std::optional<dense::Ridge> errors;
    Eigen::MatrixXd left;  ///< ∂r/∂θ and r − (∂r/∂u)u of all states without F
  };
  Line eliminated(const LineLayout::Line& own, const std::vector<LiftedState>& states, const Eigen::VectorXd& slopes,
                  const Eigen::VectorXd& errors) const;

  const LineLayout& layout_;
  const LawUnknowns& unknowns_;
  std::size_t threads_;
  LineErrors errors_;
  std::vector<Line> lines_;
  std::vector<Harmonics> harmonics_;  ///< of each state
  Eigen::Index joints_ = 0;
  minimise::Linearised reduced_;
};

}  // namespace jointid::response
