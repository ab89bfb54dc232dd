#pragma once

#include <optional>

#include "ident/likelihood/elimination/right_sides.hpp"
#include "ident/likelihood/line/reduced_line.hpp"

namespace jointid::ident {

/// A line reduced to its real unknowns, by what is left of the square of its right-hand sides once X and Y are eliminated (the lower
/// triangle) and by U⁻¹ of them, X and Y × sides; nullptr: no way back. Empty where χ² is no number.
std::optional<ReducedLine> shared_reduction(const RightSides& sides, const ComplexMatrix& square, const ComplexMatrix* steps);

}  // namespace jointid::ident
