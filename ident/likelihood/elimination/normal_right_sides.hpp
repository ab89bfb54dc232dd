#pragma once

#include "ident/likelihood/elimination/element_weights.hpp"
#include "ident/likelihood/elimination/right_sides.hpp"

namespace jointid::ident {

/// Jᴴ W² F and Fᴴ W² F of the right-hand sides F of a line, J the derivatives of its elements by X and Y. By A and D column by column,
/// U = Pᴴ W_A² F_A + conj(h) W_D² F_D is that of X, with conj(G) (W_D² F_D)ᵀ beside it, and −U Gᴴ, folded, that of Y; and by B
/// Pᴴ W_B² F_B (I − Z B)ᴴ.
class NormalRightSides {
 public:
  /// `with_differences`: D counts, too.
  void take(const LineLayout& layout, const ElementWeights& weights, const RightSides& sides, const LineFactors& factors,
            bool with_differences);

  const ComplexMatrix& values() const { return values_; }  ///< X and Y × sides
  const ComplexMatrix& square() const { return square_; }  ///< sides × sides, the lower triangle

 private:
  using Sides = Eigen::Ref<const ComplexMatrix>;

  void take_given(const LineLayout& layout, const Eigen::VectorXd& squared, const Sides& sides, bool with_differences);
  void add_given(const LineLayout& layout, Eigen::Ref<ComplexMatrix> out);
  void add_by_second(const LineLayout& layout, const Eigen::VectorXd& squared, const Sides& sides, Eigen::Ref<ComplexMatrix> out);
  void take_square(const RightSides& sides, Eigen::Index used);

  Eigen::VectorXd squared_;
  ComplexMatrix values_, square_;
  ComplexMatrix weighed_, given_, left_, second_left_, told_, by_, of_y_;
};

/// Adds a change of Y by all of its elements, as one by those that a line has, Y being symmetric.
void fold(const LineLayout& layout, const Complex* matrix, Complex* out);

}  // namespace jointid::ident
