#pragma once

#include "ident/likelihood/line_data.hpp"
#include "ident/likelihood/line_state.hpp"

namespace jointid::ident {

/// X and Y as measured; zero where not.
LineState measured_start(const LineLayout& layout, const LineData& data);

/// X and Y that explain the measured A and B with the joint Z: weighted linear least squares of X − A − Y Z A = 0,
/// Y − B − Y Z B = 0 with A and B as measured, and of the measured X and Y. Near resonances of the assembly, where small errors of
/// Y turn the predicted A over, this is on the right side of the resonance.
LineState assembly_start(const LineLayout& layout, const LineData& data, const ComplexMatrix& z);

}  // namespace jointid::ident
