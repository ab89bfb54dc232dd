#pragma once

#include "ident/likelihood/fit/estimator.hpp"
#include "ident/result/identifiability.hpp"

namespace jointid::ident {

/// How far the joint can be seen (docs/formulas.md §11i, thesis §6.8), as medians over coordinates and lines:
///   effect: |H_sub − H_asm| of a real or imaginary part over its standard deviation, measured values;
///   deformation: |aᵀ δZ a| / |xᵀ δZ x|, the work that a change δZ of the joint in `direction` (scaled unknowns) does on the motion
///   of the joint's coordinates in the assembly, a = H_asm(j,k), and on that of the free parts, x = H_sub(j,k). About 1 for a
///   joint that does not hold the parts together, and small where it holds them so that it does not deform.
JointVisibility joint_visibility(const LikelihoodData& data, const LinearisedLikelihood& estimator,
                                 const std::vector<double>& direction);

/// Identifiability::stiff_pairs: pairs (i, j) of one direction, each coordinate once, those held most first, with a median of
/// |a_i − a_j| / |x_i − x_j| below 0.1, which is 0.01 in terms of work.
std::vector<std::array<std::string, 2>> stiff_pairs(const LikelihoodData& data, const LinearisedLikelihood& estimator);

}  // namespace jointid::ident
