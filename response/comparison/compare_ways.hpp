#pragma once

#include <functional>
#include <string>
#include <vector>

#include "response/stability/matrix_assembly.hpp"

namespace jointid::response {

/// One way to a periodic response: what it took and how far it is from the exact orbit.
struct WayResult {
  std::string way;            ///< "harmonics to 9", "Algorithm One, T/1000", "exact"
  bool found = false;         ///< false: no convergence; the figures are empty
  double seconds = 0.0;       ///< of this one call, by the clock
  double periods = 0.0;       ///< marched
  int steps = 0;              ///< of Newton's method (harmonic balance, exact), or solutions of linear systems (Algorithm One)
  double largest = 0.0;       ///< max |x|, m
  double of_largest = 0.0;    ///< its error, with its sign, in parts of the exact one
  double of_amplitude = 0.0;  ///< |X_n − exact|/|exact| of the lowest harmonic of the force above 0
  bool residual_force_free =
      false;                ///< of the exact one: a joint may keep any of a family of forces, so means differ, and max |x|
  Complex amplitude = 0.0;  ///< X_n of the lowest harmonic of the force above 0, m
  double of_motion = 0.0;   ///< largest |x(t) − exact| at 100 times of a period, means left out, in parts of the exact max |x|
};

struct WaysAsked {
  std::vector<int> largest_harmonics = {1, 3, 5, 9};      ///< harmonic balance up to these (odd ones where those suffice)
  std::vector<int> steps_per_period = {100, 1000, 5000};  ///< of the algorithms; multiples of 100
  int most_periods = 500;                                 ///< marched from rest by the algorithms
  double settled = 1e-6;  ///< they stop where ‖x(t+T) − x(t)‖ ≤ settled (1 − μ)‖x‖, μ the ratio of two such differences
  std::function<void(const std::string& way)> begin{};  ///< called before each; what it throws ends the comparison
};

/// The exact orbit (first; its errors are the closure that it reached), harmonic balance, Algorithms One and Two from rest until
/// they settle, of the motion Rᵀx, `response` R of N × 1. Alone the exact orbit where that was not found. Throws InputError for
/// what time marching does not know.
std::vector<WayResult> compare_ways(const MatrixAssembly& assembly, const Excitation& force, double omega, double level,
                                    const Eigen::VectorXd& response, const WaysAsked& asked = {});

}  // namespace jointid::response
