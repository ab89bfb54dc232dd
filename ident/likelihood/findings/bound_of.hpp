#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "ident/likelihood/fit/estimator.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"

namespace jointid::ident {

/// √diag of the inverse of an information on the scaled unknowns of a plan, and systematic errors after them, in SI; infinite where it
/// fixes nothing.
std::vector<double> bound_of(const Plan& plan, const Eigen::MatrixXd& information);

/// Reads all lines of a plan with method "likelihood".
void read_observations(const Plan& plan, const Control& control);

/// The same of FRFs that are to be measured: where [noise] gives FRFs there and back errors of their own, exact ones that agree are two.
void read_for_bound(const Plan& plan, const Control& control);

/// An estimator on what was read, with the priors of the plan. It stops between lines as `control` says, which must outlive it
/// and is told `stage` (nullptr: "likelihood") and how many lines are begun.
LikelihoodEstimator make_estimator(const Plan& plan, const Control& control, std::shared_ptr<const std::string> stage = nullptr);

}  // namespace jointid::ident
