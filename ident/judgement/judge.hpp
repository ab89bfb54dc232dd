#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "ident/judgement/constrained_scatter.hpp"
#include "ident/judgement/tell_errors.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "ident/result/solution.hpp"
#include "minimise/linear/linear_solution.hpp"

namespace jointid::ident {

/// Holds a linear estimate against its data: fills Estimate::error_estimate and bias, BandMatrices::errors and Fit::misfit, and
/// sets the status:
///   poor_fit  WhitenedFit::misfit > 4, or that of a row or column > 16, or a joint matrix gives energy away (active_motions())
///   beyond
///             six deviations of the estimate without bias and five of the estimate itself;
///   doubtful  misfit > 1.5 (3 where the noise is read off the scatter, or the bias could not be taken off), or that of a row or
///   column > 4; or no joint at all explains the FRFs (WhitenedFit::free_misfit < 1.3).
/// Nothing is said of the misfit where nothing is known of the noise (read_noisy_lines()). The direct solution, which has no
/// equation of Method One, is held against what it predicts of H_nn (PredictedFit). Also doubtful: tell_errors(), and a line that
/// decides alone (dominant_line()). Constraints are held against the data instead (judge_constraints()); `free` has the unknowns
/// without them.
void judge_linear(const Plan& plan, const minimise::LinearSolution& linear, const std::vector<double>& free, const Control& control,
                  Solution& out);

/// Holds a joint that was found from H_nn alone against its data. `scatter`: covariance of the scaled unknowns theta by the
/// scatter of the lines. Errors and status as judge_linear() gives them.
void judge_predicted(const Plan& plan, const std::vector<double>& theta, const Eigen::MatrixXd& scatter, Solution& out);

/// Holds a joint that was found from H_nn alone, under constraints, against its data and these against them. `scatter`: of the scaled
/// unknowns; empty: not known, then there are no errors.
void judge_predicted_constraints(const Plan& plan, const std::vector<double>& theta, const std::optional<ConstrainedScatter>& scatter,
                                 Solution& out);

/// Doubtful where the FRFs of the assembly by this joint (Fit::asm_frf_error) are off by more than 10 dB, a factor of three, while
/// nothing is known of the noise, so that there is no Fit::misfit.
void judge_unknown_noise(Solution& out);

/// "Most suspect: sign 125:+Y in assembly.uff. …" with its evidence.
std::string phrase(const Suspect& suspect);

/// Adds what a check of the data found: doubtful when it is suspicious, poor_fit when something is wrong.
void tell_check(const CheckResult& found, Solution& out);

/// What judge_likelihood() needs of a fit.
struct LikelihoodJudgement {
  const std::vector<double>& theta;
  const Eigen::MatrixXd& covariance;
  bool hopeless = false;  ///< it was stopped because no joint would mend the misfit
  bool several_minima = false;  ///< a joint that fits may be where no start led
  double likely = 1.4;          ///< χ² over degrees of freedom that chance leaves
  double ratio = 0.0;           ///< that of the lines without gross errors
  bool includes_misfit = false;  ///< errors and intervals are those of the misfit, too
};

/// Holds an estimate of method likelihood, whose χ² is in `out`, against its law. With ρ the mean χ² over f of the lines, without
/// those that are outlying (at most one in five; else of all):
///   poor_fit  ρ > 4 where errors include the misfit, else ρ > 2 where all variances are known, 4 where some come from averages, repeats
///             or the scatter of the data; or K, C or D gives energy away beyond five standard deviations. No errors and intervals
///             then, they would not hold, but where they include the misfit and ρ is 64 at most;
///   doubtful  ρ > `likely`; or
///             JointVisibility::effect < 0.8: no joint is seen.
void judge_likelihood(const Plan& plan, const LikelihoodJudgement& fit, const Control& control, Solution& out);

}  // namespace jointid::ident
