#pragma once

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "ident/result/decibel_error.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// Predicts the assembly's FRFs of all lines of a plan from those of the substructures and the joint,
/// H_asm = H_sub − H_:b (I + Z_j H_bb)⁻¹ Z_j H_b: (docs/formulas.md §2, 6.12–6.15), each line with the matrices of the
/// band that it lies in, and compares them with the measured ones.
DecibelError predict(const Plan& plan, const std::vector<BandMatrices>& bands, const Control& control);

/// Hands an estimate to Control::so_far and, with Detail::full, fills Fit::asm_frf_error: the rms of that over the FRFs that the plan
/// predicts, dB; empty where it predicts none.
void tell_and_predict(const Plan& plan, const Control& control, Solution& out);

}  // namespace jointid::ident
