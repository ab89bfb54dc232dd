#pragma once

#include "ident/likelihood/line/line_data.hpp"
#include "ident/plan/joint_impedance.hpp"

namespace jointid::ident {

/// Where a line stands: current values of the true FRFs. On the constraint A = (I + Y Z)⁻¹ X and B = (I + Y Z)⁻¹ Y; while the
/// implicit estimator is under way A and B are values of their own.
struct LineState {
  ComplexMatrix sub_jn, sub_jj;  ///< N×n, N×N
  ComplexMatrix asm_jn, asm_jj;  ///< N×n, N×N (empty where no asm_jj is measured)
};

/// A change of the free FRFs of a line, in the order of LineLayout::sub_jn and sub_jj, real and imaginary part in turn.
using LineStep = Eigen::VectorXd;

/// X and Y moved by `scale` times a step.
void move(const LineLayout& layout, const LineStep& step, double scale, ComplexMatrix& x, ComplexMatrix& y);

/// X and Y where they are measured; the rest of the state stays.
void take_measured(const LineLayout& layout, const LineData& data, LineState& state);

/// Measured X and Y, zero where there are none; no A and B.
LineState measured_start(const LineLayout& layout, const LineData& data);

/// A and B that belong to X, Y and Z.
void put_on_constraint(const LineLayout& layout, const ComplexMatrix& z, LineState& state);

/// Σ weight²·residual² of a line at X and Y with A, B and D as the joint Z makes them: its χ².
double line_cost(const LineLayout& layout, const LineData& data, const ComplexMatrix& z, const ComplexMatrix& x,
                 const ComplexMatrix& y);

/// Puts the state on the constraint and returns line_cost() there.
double cost_on_constraint(const LineLayout& layout, const LineData& data, const ComplexMatrix& z, LineState& state);

/// The FRFs that the state predicts: H_sub(n,n) − H_asm(n,n) = Xᵀ Z A.
Complex predicted_difference(const LineState& state, const ComplexMatrix& za, Element at);

}  // namespace jointid::ident
