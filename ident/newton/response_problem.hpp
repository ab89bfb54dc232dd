#pragma once

#include <functional>
#include <utility>

#include "ident/newton/response_line.hpp"
#include "minimise/least_squares.hpp"

namespace jointid::ident {

/// All lines of (6.12), docs/formulas.md §7, as least squares Σ α_i²‖F_i‖² in scaled unknowns q = θ/scale, with lines weighted by α_i
/// and some left out.
class ResponseProblem final : public minimise::LeastSquares {
 public:
  /// `unknowns`: of the whole problem.
  ResponseProblem(std::vector<ResponseLine> lines, std::size_t unknowns);

  std::size_t unknowns() const override { return scale_.size(); }
  std::size_t residuals() const override;
  bool evaluate(std::span<const double> q, std::span<double> r, std::span<double> jacobian) const override;

  /// Asked before each line is worked out: where true, no line is defined any longer, and every minimiser soon ends.
  void stop_when(std::function<bool()> interrupted) { interrupted_ = std::move(interrupted); }

  /// θ/scale, with scales such that a unit of every unknown would move the FRFs of the free joint about as far as the joint does:
  /// thesis §6.12.2.2 wants unknowns of about one size.
  std::vector<double> scaled(const std::vector<double>& theta) const;
  std::vector<double> theta(std::span<const double> q) const;
  const std::vector<double>& scale() const { return scale_; }

  /// α_i = 1/‖J(ω_i)‖ at q (6.93): every line counts the same, however near it is to a resonance. Keeps all lines as they are there for
  /// who asks next, where they are not too large.
  void weigh_at(std::span<const double> q);

  /// Lines that fit worse than 2.25 times the median count for less, by Huber's weight; after weigh_at().
  void distrust_outliers(std::span<const double> q);

  /// Uses the lines on which predicted and measured FRFs correlate (§6.12.2.4: not those between a predicted resonance and the
  /// measured one); all lines where fewer than two per unknown do. `draw` chooses among them, in the order of the lines.
  void select_at(std::span<const double> q, const std::function<bool()>& draw = {});
  void select_all();
  std::size_t selected() const;

  /// F of a line and its Jacobian by θ, and by what they are multiplied in the weighted problem in q.
  struct Rows {
    std::span<const double> f, jacobian;         ///< [count], [count × columns]
    double weight;                               ///< of F
    std::span<const double> factor;              ///< of every column of the Jacobian
    const std::vector<std::size_t>& columns;
  };

  /// Calls `visit` with every line used. False where one is not defined. Memory: one line, beside those that are kept.
  using RowVisitor = std::function<void(const Rows& rows)>;
  bool each_line(std::span<const double> q, bool with_jacobian, const RowVisitor& visit) const;

  /// Σ α²‖F‖² of the lines used.
  double cost(std::span<const double> q) const;

  /// How badly a joint predicts the assembly: mean over the lines of log(1 + ‖F‖²/‖H_aa − H_nn‖²). A few lines do not decide it.
  double misfit(std::span<const double> q) const;

 private:
  /// F and the Jacobian by θ of a line.
  struct Line {
    bool defined = false;
    std::vector<double> f, jacobian;
  };

  void work_out(std::size_t line, const std::vector<double>& theta, bool with_jacobian, Line& to) const;
  const Line* line_at(std::size_t line, const std::vector<double>& theta, bool with_jacobian) const;
  void keep(const std::vector<double>& theta);

  std::vector<ResponseLine> lines_;
  std::vector<double> weight_, scale_;
  std::vector<char> used_;
  std::vector<double> kept_at_;  ///< θ where all lines were worked out last; empty: nowhere
  std::vector<Line> kept_;
  mutable Line at_hand_;
  std::function<bool()> interrupted_;
};

}  // namespace jointid::ident
