#pragma once

#include "ident/likelihood/fit/estimator.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// Gains, delays and masses of a fit in their units; errors by the inverse of `information`, of all unknowns.
std::vector<SystematicEstimate> systematic_estimates(const Plan& plan, const LikelihoodFit& fit,
                                                     const Eigen::MatrixXd& information);

/// What systematic errors have of the variance of every determined unknown, and a finding where that is half or more:
/// of all C_ss: 1 − (I_jj⁻¹)_ii / C_ii, of one k alone the squared correlation C_ik² / (C_ii C_kk), C the covariance of all
/// unknowns.
void tell_calibration(const Plan& plan, const Eigen::MatrixXd& information, Solution& out);

/// Status doubtful: stiffness or mass of a part that is a model is further off than its description states, by the data.
void tell_model_errors(const Plan& plan, const LikelihoodFit& fit, const Eigen::MatrixXd& information, Solution& out);

}  // namespace jointid::ident
