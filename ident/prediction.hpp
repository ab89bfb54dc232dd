#pragma once

#include "ident/control.hpp"
#include "ident/decibel_error.hpp"
#include "ident/plan.hpp"

namespace jointid::ident {

/// Predicts the assembly's FRFs of all lines of a plan from those of the substructures and the joint,
/// H_asm = H_sub − H_:b (I + Z_j H_bb)⁻¹ Z_j H_b: (docs/formulas.md §2, 6.12–6.15), each line with the matrices of the
/// band that it lies in, and compares them with the measured ones.
DecibelError predict(Plan& plan, const std::vector<BandMatrices>& bands, const Control& control);

}  // namespace jointid::ident
