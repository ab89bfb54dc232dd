#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "records/estimate/estimate.hpp"

namespace jointid::records {

/// Takes the damping that an exponential window e^(−t/τ) has added out of FRFs. What was estimated on line ω is H(iω + 1/τ).
/// Around every line a rational function (degree 2 over degree 2, least squares linearised as by Levy 1959) of the nine lines
/// next to it, local rational modelling (McKelvey & Guérin, SYSID 2012), is continued to iω: exact for a mode on a constant rest,
/// and good to what a few modes leave beyond it, as long as the motion has died away at the end of the stretch (the window leaves
/// e^(−T/τ) of what is there then). Variances and covariances follow by the linear part of the continuation; both parts of a
/// value then have one variance. Coherences stay. Lines whose nine are not all known become NaN.
///
/// Errors of lines next to each other are not independent, as the window shortens the stretch: `correlation` [9] are
/// E[e_(k+d) e_k*] / E|e_k|², d = 0 … 8, see line_correlation(). `spacing_hz` of the lines; with less than nine everything
/// becomes NaN.
void correct_decay(Estimate& estimate, std::size_t responses, double spacing_hz, double decay_time_s,
                   std::span<const Complex> correlation);

/// Of white noise under a window w of N samples, over the spectrum of a blow at sample p: Σ w² e^(−2πi d (t−p)/N) / Σ w², d = 0
/// … 8.
std::vector<Complex> line_correlation(std::span<const double> window, double peak);

}  // namespace jointid::records
