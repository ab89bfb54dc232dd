#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ident/judgement/noisy_lines.hpp"

namespace jointid::ident {

/// The joint that the equations of Method One tell when each is weighed by what the errors of its FRFs make of it, and how well
/// they agree with it. With r = A Z B − C, P = Z B and Q = A Z,
///   var r = Σ_j var(A_rj)|P_jm + [m is j]|² + Σ_j var(B_jm)|Q_rj − [r is j]|² + var(C_rm) + Σ_jk var(A_rj)|Z_jk|²var(B_km),
/// where C has A_rj and B_jm in its joint columns and rows. Where a file of the substructures has covariances, the errors of a column of
/// B and C count with them: ‖(q_r F_B − [r is no joint coordinate] F_C,r)‖² with C = F Fᴴ, q_r = Q_r − [r is j].
/// The weighted normal equations are corrected by what the same errors add to them on average (E[Σ w Re conj(∂r/∂y_k) r] at the truth,
/// errors in variables), which makes the estimate free of bias to first order; where the residuals are smaller than the assumed noise would
/// make them, by that much less of it. Correlations between equations are left out: it is no estimate of least variance.
struct WhitenedFit {
  std::vector<double> theta;   ///< scaled unknowns, as LinearSolution::y
  Eigen::MatrixXd covariance;  ///< of theta, from the scatter of the lines' gradients (sandwich)
  /// The same by leaving out one line after the other, which lines that decide alone make larger; empty without constraints.
  Eigen::MatrixXd jackknife;
  bool corrected = false;      ///< false: noise hides so much of the coefficients that the bias could not be taken off
  /// |r|²/var r: the mean of a line's equations, the middle one of all lines. About 1, or less, when the data agree with a joint.
  double misfit = 0.0;
  double free_misfit = 0.0;  ///< the same without any joint: about 1 where the assembly moves as its parts alone do
  std::vector<double> row_misfit, column_misfit;  ///< the same of the equations of a row or a column; NaN where there are none
  std::size_t lines = 0;                          ///< with any equation
};

/// Starts from the scaled unknowns of an estimate. Empty where no line has an equation with noise.
std::optional<WhitenedFit> whitened_fit(const Plan& plan, const NoisyLines& data, std::vector<double> start);

/// Whether the data contradict every joint of a scene: WhitenedFit::misfit above 9, from the scaled unknowns of any estimate.
/// False where that cannot be told.
bool beyond_any_joint(const Plan& plan, const std::vector<double>& theta);

/// Lines for whitened_fit(), as many as it takes in about a second. Empty where those are not even a few, where errors have much
/// in common (modal models, couple_first), and as read_noisy_lines().
std::optional<NoisyLines> lines_to_judge(const Plan& plan);

}  // namespace jointid::ident
