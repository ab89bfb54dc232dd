#pragma once

#include <optional>

#include "ident/likelihood/fit/linearised_likelihood.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"

namespace jointid::ident {

/// How estimates scatter by errors that a sensor, or a hit, has on all lines alike: a place or a direction that is a little off.
struct SensorScatter {
  Eigen::VectorXd variance;  ///< of the unknowns of the fit
  Eigen::VectorXd freedom;   ///< degrees of freedom of each, by how evenly sensors tell of it
};

/// Delete-a-sensor jackknife, to first order: without the FRFs that sensor s measured, in all files and on all lines, θ moves by
/// (I − I_s)⁻¹ u_s, u_s the part of the θ-score that their residuals make. So for every response coordinate and every reference
/// coordinate; what both do adds up. I_s is that of random signs on the FRFs of s, one draw a line: unbiased. Errors that look like
/// another joint leave no residual and are not in it. `information`: I of the unknowns of the fit. Empty where a sensor alone fixes an
/// unknown, or a kind has fewer than three.
std::optional<SensorScatter> sensor_scatter(const Plan& plan, const LinearisedLikelihood& estimator, const LikelihoodFit& fit,
                                            const Eigen::MatrixXd& information, const Control& control);

}  // namespace jointid::ident
