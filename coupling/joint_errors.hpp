#pragma once

#include "coupling/layout.hpp"
#include "coupling/propagation.hpp"

namespace jointid::coupling {

/// Adds to variances of H_asm (and its covariances, where there are some) what the errors θ of the joints' unknowns make of it,
/// δH_asm = L δH R + Σ_m D_m θ_m with D_m = −(L₂ H₁)_:j ∂Z/∂θ_m (H₁ R₂)_j: for H₁ with the joints, and what θ has in common with the
/// errors of H: 2 Re D_m Re E[(L ε R) θ_m] for the real part. `conditions` are L₂ and R₂, `all` L and R.
struct JointErrorTerms {
  const Sensitivity &conditions, &all;
  const MatrixRef& with_joint;  ///< H₁
  const LayoutJoint& joint;
  double omega;
  const Wanted& wanted;
};
void add_joint_errors(const JointErrorTerms& terms, const std::vector<ComplexMatrix>& common, LineVariance& variance);

}  // namespace jointid::coupling
