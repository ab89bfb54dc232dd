#pragma once

#include "ident/likelihood/data/likelihood_data.hpp"
#include "ident/likelihood/fit/estimator.hpp"

namespace jointid::ident {

/// The same maximum-likelihood estimate as LikelihoodEstimator::run(), found by Ceres in the explicit form, as bundle adjustment
/// has it: parameter blocks are the joint's unknowns and, per line, the free FRFs X and Y; per line one residual block with the
/// robust loss on its χ². Levenberg–Marquardt eliminates the lines (Schur complement; DENSE_SCHUR, as all lines share the one
/// block of the joint). An independent check, and slower.
///
/// The explicit cost has local minima on lines near resonances, and a line that is in one stays there. Therefore the joint starts
/// at `start` (IQML) and every line is first relaxed for that joint alone, from the measured FRFs and, if it does not fit then, from
/// where lifted_start() puts it, unless most lines do not fit: then it is the joint. After each solution lines that do not fit are
/// relaxed again in this way, and where that helps all is solved again.
/// Variances that follow a law of the value are then taken at the estimated values, and so on until the joint stays.
///
/// One thread: sums of several would depend on their timing.
LikelihoodFit adjust_bundle(LikelihoodData& observations, const restrictions::Restriction& restriction,
                            const UnknownColumns& columns, double omega0, const LikelihoodFit& start, const FitWatcher& watch);

}  // namespace jointid::ident
