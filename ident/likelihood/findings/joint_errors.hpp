#pragma once

#include <Eigen/Core>
#include <vector>

#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"

namespace jointid::ident {

/// The errors θ of a joint that method "likelihood" has found, and what they have in common with the errors ε of the parts' FRFs, which
/// it was found from. The estimate is the best of all linear ones of small errors: an FRF as measured and as estimated differ by what has
/// nothing to do with θ, so that E[ε θᵀ] is that of the estimated FRF, which answers to θ by dH/dθ: (dH/dθ) C.
struct JointErrors {
  Eigen::MatrixXd covariance;        ///< C of the columns of the plan, SI units
  Dofs coordinates;                  ///< of the parts' FRFs
  std::vector<double> frequency_hz;  ///< of the lines
  std::vector<std::vector<Complex>> common;  ///< [line][pair · p + m] E[ε θ_m], pair = frf::pair_index(row, column), row ≥ column

  std::size_t unknowns() const { return static_cast<std::size_t>(covariance.rows()); }
};

/// Throws InputError (usage) for what joint_errors() does not work out: another method, joints with bounds, ties or bands,
/// systematic errors, parts that were coupled before or replaced by modal models.
void require_joint_errors(const Plan& plan);

/// Of a plan with method "likelihood" that was solved, at the values found (SI, one per column). To first order in the noise,
/// from FRFs that are optimised for the joint anew. Throws as require_joint_errors().
JointErrors joint_errors(const Plan& plan, const std::vector<double>& values, const Control& control = {});

}  // namespace jointid::ident
