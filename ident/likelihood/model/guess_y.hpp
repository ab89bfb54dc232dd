#pragma once

#include "ident/likelihood/line/line_data.hpp"
#include "ident/likelihood/line/line_state.hpp"

namespace jointid::ident {

/// Puts a guess of those FRFs of Y = H_sub(j,j) that were not measured into a state whose X and measured Y are there: the
/// least-squares solution of Y Z A = X − A at the measured A, with Y symmetric and zero where the layout has it so. Z may be
/// singular (the stiffness of a free joint element is). Rows count by the size of their FRFs; without any complete column of A
/// the guess is zero.
void guess_y(const LineLayout& layout, const LineData& data, const ComplexMatrix& z, LineState& state);

}  // namespace jointid::ident
