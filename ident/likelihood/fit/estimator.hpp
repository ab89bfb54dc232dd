#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "ident/likelihood/data/scaled_prior.hpp"
#include "ident/likelihood/fit/likelihood_fit.hpp"
#include "ident/likelihood/fit/linearised_likelihood.hpp"

namespace jointid::ident {

/// What an estimator is made of beside data and unknowns.
struct EstimatorOptions {
  std::size_t threads = 0;             ///< 0: all cores
  std::vector<ScaledPrior> priors{};   ///< PenalisedLines
  std::function<void(std::size_t begun, std::size_t lines)> line_watch{};  ///< FittedLines::set_watch()
};

/// Maximum-likelihood estimate of the joint with all FRFs taken as noisy (docs/formulas.md §11d): minimises Σ_lines L(χ²) over the
/// joint's unknowns and the true substructure FRFs of every line; L is χ² for lines that fit, and bounded for those with gross
/// errors. Three stages (JointIteration), of many large lines on an eighth of them before:
///  1. a few steps of iterative quadratic maximum likelihood;
///  2. the implicit iteration (Gauss–Helmert), which corrects the FRFs of both systems off the constraint and so comes near from
///     poor starts;
///  3. Gauss–Newton steps of the joint and of the FRFs of every line, which are eliminated from the step, shortened until Σ L falls;
///     where χ² of a line is not what was predicted, and in the end, its FRFs are optimised for the joint (Levenberg–Marquardt of
///     the line on its own). The cost never rises.
/// Where variances follow a law of the value they are then taken at the estimated values and stage 3 is repeated until the joint
/// stays: weights at measured values bias the estimate.
///
/// Nothing is fitted yet: what a fit leaves is a LinearisedLikelihood, which takes the lines along. So an estimator fits once.
class LikelihoodEstimator {
 public:
  LikelihoodEstimator(LikelihoodData& observations, const restrictions::Restriction& restriction, const UnknownColumns& columns,
                      double omega0, EstimatorOptions options);

  /// How far the lines are from fitting a joint, to rank starts by: the mean over the lines of log(1 + χ²/r), weighted by their
  /// redundancy r, with χ² as linearised where the iteration would begin. A few lines near resonances do not decide it. The starts of
  /// run() may ask, too.
  double misfit_at(std::vector<double> theta);

  /// Starts are of the joint's unknowns, or of all; systematic errors begin at zero otherwise.
  /// From the first start, and from the next while χ² tells that the fit is not the right minimum, or from all; the best of them.
  LinearisedLikelihood run(const Starts& starts, const FitWatcher& watch, FollowOptions options = {}) &&;

  /// The last stage alone, from a start that is nearly right.
  LinearisedLikelihood refine(std::vector<double> start, const FitWatcher& watch) &&;

  /// Only iterative quadratic maximum likelihood, to its end: the conditions between the measured FRFs, which are linear in the
  /// joint, whitened by the covariance that the last joint gives them. Each step costs as much as one of the Gauss–Helmert
  /// iteration and no line can get stuck, but errors of the coefficients bias it: for small noise only as good as run().
  LinearisedLikelihood run_whitened(std::vector<double> start, const FitWatcher& watch, FollowOptions options = {}) &&;

  /// The data if the joint were `theta`: LinearisedLikelihood::fit has theta and the Fisher information on all unknowns there.
  LinearisedLikelihood at(std::vector<double> theta) &&;

 private:
  LikelihoodFit run_from(std::vector<double> start, JointIteration iteration, const LikelihoodFit* known, const FitWatcher& watch);
  std::optional<LikelihoodFit> approached(const std::vector<double>& start, const FitWatcher& watch);
  bool takes_linearised(const std::vector<double>& start);

  PenalisedLines all_;
  std::optional<std::vector<double>> linearised_at_;  ///< by misfit_at(): where lines stand and are linearised already
};

}  // namespace jointid::ident
