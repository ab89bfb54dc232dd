#pragma once

#include "ident/identifiability.hpp"
#include "ident/likelihood/estimator.hpp"

namespace jointid::ident {

/// How far the joint can be seen (thesis §6.8.1), in standard deviations of the FRFs, as medians over the lines:
///   effect: rms over real and imaginary parts of (H_sub − H_asm)/√(σ²_sub + σ²_asm), measured values;
///   deformation: √λ_min of S⁻¹ A Aᴴ S⁻¹, A = H_asm(j,n) estimated, S² = diag of the sums of the variances of the rows of A:
///   the combination of joint coordinates that moves least. Below 1 the rows cannot be told from dependent ones.
JointVisibility joint_visibility(const LikelihoodData& data, const LikelihoodEstimator& estimator);

}  // namespace jointid::ident
