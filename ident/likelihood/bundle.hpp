#pragma once

#include "ident/likelihood/estimator.hpp"

namespace jointid::ident {

/// The same maximum-likelihood estimate as LikelihoodEstimator::run(), found by Ceres in the explicit form, as bundle adjustment
/// has it: parameter blocks are the joint's unknowns and, per line, the free FRFs X and Y; per line one residual block with the
/// robust loss on its χ². Levenberg–Marquardt eliminates the lines (Schur complement). An independent check, and slower.
///
/// The explicit cost has local minima on lines near resonances. Therefore the joint starts at `start` (IQML); every line is
/// first relaxed for that joint from the measured FRFs and from those that explain the measured assembly, and keeps the better.
/// After each solution lines that do not fit are relaxed again from both, and where that helps all is solved again.
/// Variances that follow a law of the value are then taken at the estimated values, and so on until the joint stays.
///
/// One thread: sums of several would depend on their timing.
LikelihoodFit adjust_bundle(Observations& observations, const restrictions::Restriction& restriction,
                            const UnknownColumns& columns, double omega0, const LikelihoodFit& start, const FitWatcher& watch);

}  // namespace jointid::ident
