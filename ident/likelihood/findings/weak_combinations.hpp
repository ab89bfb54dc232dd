#pragma once

#include <Eigen/Core>
#include <vector>

#include "ident/plan/plan.hpp"
#include "ident/result/identifiability.hpp"

namespace jointid::ident {

/// What deviations of the unknowns are related to, one per column (SI): |value|, or the largest |value| of the same matrix and
/// unit (else of the same matrix) where that is more than a thousand times as large. 0 where all of them are 0.
std::vector<double> relative_scales(const Plan& plan, const std::vector<double>& values);

/// From the covariance in relative units, R(i,j) = C(i,j)/(scale_i scale_j), of the columns `which`: the eigenvectors of the
/// largest eigenvalues, at most three, with the unknowns that take part by 0.3 of the largest part or more. Among those
/// unknowns the eigenvectors of their own block of R are the combinations known worst and best.
std::vector<WeakCombination> weak_combinations(const Eigen::MatrixXd& relative_covariance, const std::vector<std::string>& names);

}  // namespace jointid::ident
