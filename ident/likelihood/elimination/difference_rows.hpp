#pragma once

#include <vector>

#include "ident/likelihood/elimination/eliminated_columns.hpp"
#include "ident/likelihood/line/line_data.hpp"
#include "ident/likelihood/line/line_factors.hpp"

namespace jointid::ident {

/// The rows of D of a line as conditions of their own beside normal equations N = [M −C; −Cᴴ K] of X and Y that have all but
/// these. A row (r, k) is G_kᵀ δX_r + h_r δX_k − h_r δY G_k, J in short. With Σ = K − CᴴM⁻¹C = L_Y L_Yᴴ
///   J N⁻¹ Jᴴ = J_X M⁻¹ J_Xᴴ + H Hᴴ,   H = (J_Y + J_X M⁻¹C) L_Y⁻ᴴ,
/// and the information of the line grows by Fᴴ (W_D⁻² + J N⁻¹ Jᴴ)⁻¹ F, F what the rows are still off by.
class DifferenceRows {
 public:
  explicit DifferenceRows(const LineLayout& layout);

  /// The rows that are measured.
  void take(const LineData& data, const LineFactors& factors);

  /// `lower`: L_Y. False where D is so much more exact than all else that this way loses digits.
  bool factor(const EliminatedColumns& columns, const ComplexMatrix& lower);

  Eigen::Index size() const { return static_cast<Eigen::Index>(rows_.size()); }

  /// Of all elements of D in the order of the layout those that are measured.
  ComplexMatrix pick(const Eigen::Ref<const ComplexMatrix>& all) const;

  /// F = f − J N⁻¹ w in place of f and F's multipliers s = (W_D⁻² + J N⁻¹ Jᴴ)⁻¹ F instead of it; `x`: M⁻¹ of the part of w by X,
  /// `y`: L_Y⁻¹ of that by Y once X is eliminated. Gains Fᴴ s, the lower triangle, are added to `square`.
  void answer(const EliminatedColumns& columns, const ComplexMatrix& x, const ComplexMatrix& y, ComplexMatrix& f,
              ComplexMatrix& square) const;

  /// Adds Hᴴ s to `y`, and M⁻¹ J_Xᴴ s to `x`.
  void add_forces(const EliminatedColumns& columns, const ComplexMatrix& s, ComplexMatrix& x, ComplexMatrix& y) const;

 private:
  struct Row {
    std::size_t element, row, column;  // of D
  };

  const LineLayout& layout_;
  std::vector<Row> rows_;
  Eigen::VectorXd weights_;
  std::vector<Eigen::Index> at_row_;   ///< [n·n] where the row of a pair is; −1: nowhere
  ComplexMatrix g_, h_;                ///< N×n
  std::vector<ComplexMatrix> touch_;   ///< E_k: J of the rows (k, ·) by δX_k
  std::vector<ComplexMatrix> half_;    ///< L_k⁻¹ conj(E_k)
  ComplexMatrix towards_y_, weighed_;  ///< Hᴴ, W_D H
  ComplexMatrix lower_;                ///< of 1 + W_D J N⁻¹ Jᴴ W_D
};

}  // namespace jointid::ident
