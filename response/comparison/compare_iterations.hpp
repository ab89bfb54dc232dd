#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "response/stability/matrix_assembly.hpp"

namespace jointid::response {

/// One of chapter 4's ways to a solution of harmonic balance from one start: how it ended, what it took.
struct IterationResult {
  std::string way;                  ///< "ESD", "joint increment, best, 40 steps", "one joint, bracketed", …
  std::string start;                ///< "stuck", "free", "one harmonic"; empty where the way has none
  std::string state;                ///< "converged", "stalled", "limit"; of increments "failed"
  int largest_harmonic = 1;         ///< of the equations
  int steps = 0;                    ///< of the iteration, or of Newton's method; of the bracketed search evaluations of the force
  int searches = 0;                 ///< steps that were shortened
  double seconds = 0.0;             ///< of this one call, by the clock
  std::optional<double> factor{};   ///< spectral radius at the solution: below 1 it converges from nearby
  std::optional<double> reached{};  ///< last α of increments
  std::optional<double> of_amplitude{};  ///< |X − X_exact|/|X_exact| of the lowest harmonic, where it converged and that is known
  Eigen::MatrixXcd joint_motion{};       ///< Q_n, [harmonic, joint], m; empty unless it converged

  bool converged() const { return state == "converged"; }
};

struct IterationsAsked {
  int largest_harmonic = 9;                ///< of the second set of equations; the first has the force's harmonics alone
  int most_steps = 300;                    ///< of iterations; Newton's method 60
  std::vector<int> increments = {10, 40};  ///< equal ones
  std::optional<Complex> exact{};          ///< X of the lowest harmonic of the exact orbit
  std::function<void(const std::string& way)> begin{};  ///< called before each; what it throws ends the comparison
};

/// With the force's harmonics alone: Newton–Raphson, direct iteration, ESD, LESD from joints that stick and from joints without
/// force, the bracketed search of a single joint, force and joint increments with all estimates. With more harmonics:
/// Newton–Raphson, direct iteration and LESD from the one-harmonic solution and from the same two starts. ESD is left out where
/// the force has several harmonics. Throws InputError where a receptance is infinite.
std::vector<IterationResult> compare_iterations(const MatrixAssembly& assembly, const Excitation& force, double omega,
                                                double level, const Eigen::VectorXd& response, const IterationsAsked& asked = {});

}  // namespace jointid::response
