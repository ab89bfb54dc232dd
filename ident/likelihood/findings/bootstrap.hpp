#pragma once

#include <array>
#include <vector>

#include "ident/likelihood/fit/estimator.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"

namespace jointid::ident {

/// One replicate of a bootstrap, scaled unknowns.
struct Replicate {
  std::vector<double> theta;
  std::vector<double> error;  ///< √diag of its Cramér–Rao covariance
  bool usable = false;        ///< converged to finite numbers
};

/// Parametric bootstrap (Efron & Tibshirani 1993, ch. 6): takes the fitted joint and FRFs for the truth, adds normal errors with
/// the variances of the fit, and estimates again from the fitted joint; as often as [identify] bootstrap says. Replicate b draws
/// from stream (bootstrap_seed, b), so that the result does not depend on the threads.
std::vector<Replicate> bootstrap(const Plan& plan, const LinearisedLikelihood& fitted, const LikelihoodFit& fit, const Control& control);

/// What the usable replicates say about one unknown.
struct BootstrapError {
  double std_error = 0.0;
  std::array<double, 2> ci95{};
};
BootstrapError bootstrap_error(const std::vector<Replicate>& replicates, std::size_t column, double estimate, double error);

}  // namespace jointid::ident
