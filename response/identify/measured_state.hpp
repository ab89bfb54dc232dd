#pragma once

#include <Eigen/Core>
#include <vector>

#include "response/harmonic/excitation.hpp"
#include "response/structure/receptance.hpp"

namespace jointid::response {

/// A periodic state of an assembly as measured at one force level and line: phasors of forces and responses, x = Σ Re X_n
/// e^{inωt}.
struct MeasuredState {
  double omega = 0.0;             ///< rad/s
  Excitation force;               ///< P_n as measured, at the forces of the receptance
  std::vector<int> harmonics{1};  ///< of the responses, ascending
  Eigen::MatrixXcd response;      ///< Y_n, [harmonic, response of the receptance]
  Eigen::MatrixXd deviation;      ///< of Re Y_n and Im Y_n each, [harmonic, response]
  /// Of Re P_n and Im P_n each, as force.amplitudes (of n = 0 it counts as 0); empty: the forces are exact.
  Eigen::MatrixXd force_deviation{};

  bool knows_force_errors() const { return (force_deviation.array() > 0.0).any(); }
};

/// How many real numbers the phasors are: of the mean one, else two.
Eigen::Index measured_numbers(const MeasuredState& state);
Eigen::Index measured_numbers(const std::vector<MeasuredState>& states);

/// Numbers like the responses over the deviations, as a row of real ones: of each harmonic each response, of each Re and Im (of
/// the mean Re alone).
Eigen::VectorXd in_deviations(const MeasuredState& state, const Eigen::MatrixXcd& responses);

/// Throws InputError (data) that says which state does not fit the structure: sizes, numbers that are not finite, deviations that
/// are not above 0, harmonics nω at which the structure is not known.
void require_valid(const std::vector<MeasuredState>& states, const Receptance& structure);

/// Adds to these columns of rows (as in_deviations) what changes of the responses at one measured harmonic are, given as Re and Im
/// of each response.
void add_in_deviations(const MeasuredState& state, int harmonic, const Eigen::Ref<const Eigen::MatrixXd>& responses,
                       Eigen::Ref<Eigen::MatrixXd> columns);

inline constexpr std::size_t lines_for_a_start = 20;

/// States of so many lines, evenly among all of them: of as many stretches of lines the one at this share of each. Nothing where
/// there are fewer than twice as many lines.
std::vector<MeasuredState> some_lines(const std::vector<MeasuredState>& states, std::size_t count, double share = 0.5);

}  // namespace jointid::response
