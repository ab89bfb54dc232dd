#pragma once

#include <memory>
#include <optional>
#include <string>

#include "ident/likelihood/errors/tried_errors.hpp"
#include "ident/likelihood/fit/linearised_likelihood.hpp"
#include "ident/plan/plan.hpp"
#include "ident/result/control.hpp"
#include "ident/result/solution.hpp"

namespace jointid::ident {

/// A fit with what is asked of it at once.
struct Fitted {
  LinearisedLikelihood found;
  ChiSquare chi_square;
  double ratio = 1.0;  ///< χ² over degrees of freedom, of the lines that count
  std::optional<TriedErrors> tried = {};
  std::unique_ptr<AssumedGain> gain = {};  ///< a common gain that is one of the unknowns
  std::optional<FileGain> without = {};    ///< what the fit without that gain said of it
  Eigen::VectorXd pull = {};               ///< of the scene's inequalities; empty: none
  LinearisedLikelihood::NearbyGradients nearby = {};  ///< those that trying errors brought

  bool is_own(const Plan& plan) const { return plan.solver == Solver::gauss_helmert && found.fit.converged; }
  /// Whether intervals may hold more than the noise that variances tell.
  bool may_widen(const Plan& plan) const { return is_own(plan) && !plan.admissible && plan.scene.identify.bootstrap == 0; }
};

/// By the solver of the scene, under its constraints. `stage` is what progress tells.
Fitted fitted(const Plan& plan, const Control& control, const std::shared_ptr<std::string>& stage, Solution& out);

/// Together with the first gradients of godambe_information(), which the same factors of the lines give.
void try_errors_of(const Plan& plan, const Control& control, Fitted& all);

/// Once more with a gain of all FRFs of a file, where the data call for that and it explains them.
void fit_with_gain(const Plan& plan, const Control& control, const std::shared_ptr<std::string>& stage, Fitted& all);

}  // namespace jointid::ident
