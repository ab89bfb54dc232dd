#pragma once

#include "ident/likelihood/line/line_state.hpp"

namespace jointid::ident {

/// χ² of a line and −½ of its derivatives.
struct LineGradient {
  double cost = 0.0;
  LineStep own;           ///< by real and imaginary parts of X and Y: g
  Eigen::VectorXd joint;  ///< by the line's unknowns of the joint, X and Y held
};

/// Whether gradient_of() takes the line: errors are independent, and none is systematic.
bool has_plain_errors(const LineData& data);

/// At a state on the constraint. By adjoints: with e = weight² · residual of A, B and D as matrices, P = (I + Y Z)⁻¹, G = Z A,
///   by X: e_X + Pᴴ e_A + G* (e_D + e_Dᵀ),
///   by Y: e_Y − (Pᴴ e_A + G* e_D) Gᴴ + Pᴴ e_B P*,
///   by Z: −Bᴴ (e_A Aᴴ + e_B Bᴴ) + A* e_D Aᴴ,
/// which costs O(N n (N + n)), where the normal equations of LineModel cost O(N⁶).
LineGradient gradient_of(const LineLayout& layout, const LineData& data, const JointImpedance& joint, const ComplexMatrix& z,
                         const LineState& state);

}  // namespace jointid::ident
