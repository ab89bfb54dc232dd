#pragma once

#include "ident/likelihood/elimination/difference_rows.hpp"
#include "ident/likelihood/elimination/eliminated_columns.hpp"
#include "ident/likelihood/elimination/kronecker_squares.hpp"
#include "ident/likelihood/elimination/normal_right_sides.hpp"
#include "ident/likelihood/elimination/structured_line.hpp"

namespace jointid::ident {

/// The normal equations of a line with circular, independent errors solved by their structure: columns of X one by one, then Y,
/// of which the normal equations are sums of Kronecker products, and D by as many multipliers as it has elements
/// (docs/formulas.md §11e). The same as Cholesky factors of them all, to rounding. Not thread-safe: one per thread.
class LineElimination final : public StructuredLine {
 public:
  explicit LineElimination(const LineLayout& layout);

  /// Linearises as LineModel does, and factors. False where the line is better left to other ways: something that is not
  /// determined but by D, or is next to it.
  bool linearise(const LineData& data, const LineState& state, const LineFactors& factors, const JointImpedance* joint,
                 const SystematicTerms* terms);

  /// See LineModel.
  std::optional<ReducedLine> reduce(double damping, bool answer) override;
  LineStep own_step(const LineStep& gradient) const override;

 private:
  bool factor(double damping);
  ComplexMatrix solve(const ComplexMatrix& right, ComplexMatrix differences, ComplexMatrix& square) const;

  const LineLayout& layout_;
  EliminatedColumns columns_;
  KroneckerSquares squares_;
  DifferenceRows differences_;
  RightSides sides_;
  ElementWeights weights_;
  NormalRightSides normal_sides_;         ///< without D
  ComplexMatrix p_, g_, c_;               ///< P, Z A and I − Z B
  std::vector<ComplexMatrix> b_squares_;  ///< Pᴴ W² P by the columns of B
  ComplexMatrix off_;                     ///< right-hand sides of D
  ComplexMatrix y_lower_;
  double damping_ = 0.0;  ///< of the factors
  std::vector<WeighedRow> weighed_rows_;
  ComplexMatrix room_;
};

}  // namespace jointid::ident
