#pragma once

#include "ident/likelihood/fit/estimator.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// What the fit says about the unknowns of `out`, which has values, `determined`, std_error, intervals and χ² by now.
/// `covariance`: of the scaled unknowns; `likely`: χ² over degrees of freedom that chance leaves.
Identifiability identifiability_of(const Plan& plan, const LinearisedLikelihood& estimator, const Eigen::MatrixXd& covariance,
                                   double likely, const Solution& out);

/// Covariance in relative units (see relative_scales()) of the columns `which`, from that of the scaled unknowns.
Eigen::MatrixXd relative_covariance(const Plan& plan, const Eigen::MatrixXd& covariance, const std::vector<double>& values,
                                    const std::vector<std::size_t>& which);

}  // namespace jointid::ident
