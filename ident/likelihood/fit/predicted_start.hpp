#pragma once

#include "ident/likelihood/data/likelihood_data.hpp"
#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// Where method "newton" gets from `theta` (scaled unknowns) on the measured values of the likelihood's data; `theta` where they
/// lack what it needs, or it ends nowhere.
std::vector<double> predicted_start(const Plan& plan, const LikelihoodData& data, std::vector<double> theta);

}  // namespace jointid::ident
