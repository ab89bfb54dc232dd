#pragma once

#include "ident/plan/coordinates.hpp"
#include "ident/plan/rectangle.hpp"
#include "ident/result/solution.hpp"
#include "minimise/linear/eigen_view.hpp"

namespace jointid::ident {

/// The matrices of the band that a line lies in; null between bands.
const Matrices* matrices_at(const std::vector<BandMatrices>& bands, double frequency_hz);

/// Z_j(ω) [N×N] of docs/formulas.md §1 (6.28).
Eigen::MatrixXcd joint_impedance(const Matrices& matrices, std::size_t n, double frequency_hz);

/// `dofs`, with the joint's DOFs behind them unless they are among them.
Dofs with_joint(const Dofs& dofs, const Dofs& joint);

/// `dofs` without those of the joint, and the joint's DOFs behind them, as joint_effect() wants them.
Dofs joint_last(Dofs dofs, const Dofs& joint);

/// A rectangle that is read as a whole.
Rectangle whole_rectangle(frf::FrfSystem& system, const Dofs& rows, const Dofs& columns);

/// What a joint changes: H_asm = H_sub − left·right, for the first R rows and C columns of H_sub.
struct JointEffect {
  RowMatrixXc left;  ///< [R×N] H_:b (I + Z_j H_bb)⁻¹ Z_j
  minimise::View right;  ///< [N×C] H_b:, a part of H_sub

  /// An FRF of the assembly: that of the substructures, `h`, less the change at its row and column.
  Complex assembly(Complex h, std::size_t row, std::size_t column) const;
};

/// The effect of a joint on substructures with the FRFs `h`, whose last N rows and columns are the joint's
/// (docs/formulas.md §2, 6.12–6.15).
JointEffect joint_effect(const minimise::View& h, std::size_t rows, std::size_t columns, const Eigen::MatrixXcd& impedance);

}  // namespace jointid::ident
