#pragma once

#include "ident/likelihood/elimination/arrow_layout.hpp"
#include "ident/likelihood/elimination/kronecker_squares.hpp"
#include "ident/likelihood/elimination/normal_right_sides.hpp"
#include "ident/likelihood/elimination/row_squares.hpp"
#include "ident/likelihood/elimination/structured_line.hpp"

namespace jointid::ident {

/// The normal equations of a line with circular, independent errors by their blocks, without its rows (docs/formulas.md §11e): those of
/// ComplexRows, to rounding. Columns of X that no element of D joins with each other are eliminated one by one, then the core of all
/// others and Y (ArrowLayout). Not thread-safe: one per thread.
class ArrowElimination final : public StructuredLine {
 public:
  explicit ArrowElimination(const LineLayout& layout);

  /// Linearises as LineModel does.
  void linearise(const LineData& data, const LineState& state, const LineFactors& factors, const JointImpedance* joint,
                 const SystematicTerms* terms);

  /// See LineModel.
  std::optional<ReducedLine> reduce(double damping, bool answer) override;
  LineStep own_step(const LineStep& gradient) const override;

 private:
  Eigen::Index count_of(std::size_t k) const;
  void add_core_columns();
  void add_core_pairs(const LineData& data);
  void take_y();
  void put_right_sides();
  void add_by_y(const Complex* s, const Complex* r, std::size_t k, Complex* out) const;
  bool eliminate(const ArrowLayout::Lone& lone, double damping);
  bool factor(double damping);
  void solve_lone(const ComplexMatrix& core, ComplexMatrix& lone) const;
  ComplexMatrix in_order(const ComplexMatrix& core, const ComplexMatrix& lone) const;

  const LineLayout& layout_;
  ArrowLayout arrow_;
  RightSides sides_;
  ElementWeights weights_;
  NormalRightSides normal_sides_;
  RowSquares squares_;
  KroneckerSquares of_y_;
  ComplexMatrix g_, h_, c_;             ///< Z A, h and I − Z B
  ComplexMatrix normal_;                ///< of the core and, below it, the right-hand sides: the lower triangle, without priors
  ComplexMatrix factor_;                ///< L of the core, once lone columns are eliminated
  ComplexMatrix arms_;                  ///< [core and sides × unknowns of lone columns]: their blocks times L_k⁻ᴴ
  std::vector<ComplexMatrix> lowers_;   ///< L_k of lone columns
  ComplexMatrix square_, right_;        ///< right-hand sides: what is left of their square, and L⁻¹ of them
  ComplexMatrix y_normal_, small_;
};

}  // namespace jointid::ident
