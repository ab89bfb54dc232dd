#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "ident/plan/plan.hpp"

namespace jointid::ident {

/// FRFs of one line by which parts and joint predict H_nn of the assembly, and E|δ|² of each, (m/N)². NaN: not measured.
struct PredictedLine {
  double frequency_hz = 0.0;
  Eigen::MatrixXcd aa, ab, ba, bb, nn;  ///< [M×L], [M×N], [N×L], [N×N], [M×L]
  Eigen::MatrixXd nn_variance;          ///< of H_nn − H_aa
  Eigen::MatrixXd ab_variance, ba_variance, bb_variance;
};

/// Some lines of a plan whose assembly is not used at the joint.
struct PredictedLines {
  std::vector<PredictedLine> lines;
  bool from_knowledge = true;  ///< as NoisyLines::from_knowledge
};

/// The joint by which the parts predict H_nn best, each equation weighed by what the errors of its FRFs make of it. With
/// P = Z (I + H_bb Z)⁻¹ and F = H_nn − H_aa + H_ab P H_ba (6.12),
///   var F_rm = var(H_nn − H_aa)_rm + Σ_j var(H_ab)_rj |P H_ba|²_jm + Σ_j |H_ab P|²_rj var(H_ba)_jm
///              + Σ_jk |H_ab P|²_rj var(H_bb)_jk |P H_ba|²_km,
/// to first order. Damped Gauss–Newton steps, with the weights of where each begins, from the estimate that is judged.
struct PredictedFit {
  std::vector<double> theta;   ///< scaled unknowns
  Eigen::MatrixXd covariance;  ///< of theta, from the scatter of the lines' gradients (sandwich)
  double misfit = 0.0;  ///< |F|²/var F: the mean of a line's equations, the middle one of all lines. About 1 for a joint that fits
};

/// Lines for predicted_fit(), as many as it takes in about a second. Empty where errors have much in common (modal models,
/// couple_first), and as read_predicted_lines().
std::optional<PredictedLines> predicted_lines_to_judge(const Plan& plan);

/// Empty where no line has an equation with noise.
std::optional<PredictedFit> predicted_fit(const Plan& plan, const PredictedLines& data, const std::vector<double>& start);

}  // namespace jointid::ident
