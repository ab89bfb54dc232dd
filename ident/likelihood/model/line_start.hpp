#pragma once

#include "ident/likelihood/line/line_data.hpp"
#include "ident/likelihood/line/line_state.hpp"

namespace jointid::ident {

/// X and Y from where the explicit cost of a line leads to its minimum also near resonances of the assembly, where small errors
/// of Y turn the predicted A over. A is made free as well and bound by a penalty:
///   min Σ weight²(X, Y, A, D − measured)² + μ² ‖(X − A − Y Z A)/σ_c‖²,  D = Xᵀ Z A,
/// with σ_c the standard deviation of the condition at the measured FRFs and μ raised from 1 to 10⁴. It is bilinear and has no
/// poles. (Lifted Newton method: Albersmeyer and Diehl 2010.)
LineState lifted_start(const LineLayout& layout, const LineData& data, const ComplexMatrix& z);

}  // namespace jointid::ident
