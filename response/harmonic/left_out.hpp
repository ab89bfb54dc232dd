#pragma once

#include "response/harmonic/harmonic_balance.hpp"

namespace jointid::response {

/// The error bar of harmonics at which the structure is not known (HarmonicSolution::dropped): |δX_n| of each harmonic of the
/// solution and response, [harmonic, response], by one Newton step of the equations with those harmonics in, their H taken from
/// the nearest known line. Empty where none was dropped. A resonance beyond the lines may make it larger.
Eigen::MatrixXd left_out(const HarmonicBalance& balance, const HarmonicSolution& solution);

}  // namespace jointid::response
