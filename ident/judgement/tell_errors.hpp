#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "ident/plan/plan.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// Makes the status at least as bad as `status` (ok < doubtful < poor_fit; others stay) and adds a sentence to the message.
void tell(Solution& out, Status status, const std::string& sentence);

/// Makes an estimate doubtful whose own errors speak against it:
///   a diagonal element of K, C or D that is negative beyond its 95 % interval, by the covariance of the scaled unknowns theta,
///   or an eigenvalue that active_motions() finds beyond five deviations (two where the assembly is not measured at the joint);
///   errors (std_error, else error_estimate) that are larger than the values of more than half of the unknowns; a value counts as
///   a tenth of the largest of its matrix and unit at least; or an error of K (of a joint without K: of any matrix) that is as
///   large as the largest value of its unit: no valid digit;
///   where the assembly is not measured at the joint, a matrix K (of a joint without K: any) with an eigenvalue below −0.5 of its
///   largest, whatever its error: indefinite_matrices().
/// Of other matrices without a valid digit a warning and a sentence of the message, whatever the status: it is that of K alone.
void tell_errors(const Plan& plan, const std::vector<double>& theta, const Eigen::MatrixXd& covariance, Solution& out);

/// What tell_errors() says of errors that are as large as values.
void tell_useless_errors(const Plan& plan, Solution& out);

}  // namespace jointid::ident
