#pragma once

#include <vector>

#include "ident/likelihood/data/observations.hpp"
#include "ident/likelihood/data/scaled_prior.hpp"
#include "ident/likelihood/fit/likelihood_fit.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// Of a fit and its priors. Lines whose robust weight is below a half do not count, unless they are more than a third of all.
ChiSquare chi_square_of(const Observations& observations, const std::vector<ScaledPrior>& priors, const LikelihoodFit& fit);

/// χ² over degrees of freedom of the lines without gross errors: those with at most ten times their expectation.
double fitting_ratio(const ChiSquare& chi_square, const LikelihoodFit& fit);

/// χ² of the lines beyond its expectation, each with a weight.
double excess_of(const ChiSquare& chi_square, const Observations& observations, const std::vector<double>& weights);

}  // namespace jointid::ident
