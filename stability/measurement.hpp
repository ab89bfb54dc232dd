#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ident/result/solution.hpp"
#include "stability/extreme_scene.hpp"
#include "stability/way.hpp"

namespace jointid::stability {

/// Whether what a solution says of itself is true.
enum class Honesty {
  not_judged,    ///< the solver states no bound
  told,          ///< wrong or imprecise, and said so by status, warning or bound
  right,
  silent_wrong,  ///< an unknown is off by more than 10 times its stated bound, and neither status nor warning says so
  false_alarm    ///< status or warning, though every unknown is right to 6 digits
};
std::string name(Honesty verdict);

/// One solver on one problem. Digits are −log₁₀ of a relative error, between 0 and 16; NaN where there is nothing to compare with.
struct Measured {
  std::string sweep;     ///< which sweep it belongs to
  double value = 0.0;    ///< what the sweep varies
  std::string method, solver;
  std::size_t lines = 0, unknowns = 0;
  double digits_kept = 0.0;   ///< against the same identification of the same data in 50 digits, ‖W(y − y₅₀)‖/‖Wy₅₀‖, W = column norms
  double digits_true = 0.0;   ///< against the true unknowns, the worst over the largest of its joint
  std::optional<double> digits_stated;  ///< Fit::digits
  double condition = 0.0;
  std::size_t rank = 0;
  double seconds = 0.0;       ///< assembling and solving on one thread
  std::size_t bytes = 0;
  ident::Status status = ident::Status::ok;
  bool warned = false;
  Honesty verdict = Honesty::not_judged;
};

/// Solves the problem; OwnWay::svd on the compressed rows. Throws std::bad_variant_access for OwnWay::qr_refined. `exact`: empty where
/// there is none.
Measured measure(const ExtremeProblem& problem, Way way, const std::optional<ExactEstimate>& exact);

/// The exact estimate where the method has one.
std::optional<ExactEstimate> exact_estimate(const ExtremeProblem& problem);

/// −log₁₀ of a relative error, cut to 0 … 16.
double digits(double relative_error);

}  // namespace jointid::stability
