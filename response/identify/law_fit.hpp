#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "friction/fit/fitted_value.hpp"
#include "response/identify/fit_work.hpp"
#include "response/identify/response_residuals.hpp"

namespace jointid::response {

struct FitOfHarmonics;

struct LawFitOptions {
  std::vector<int> harmonics{};  ///< of the model beside those measured; or, when empty, added until …
  double settled = 0.1;          ///< … the estimate moves by less than this many standard deviations, whichever way …
  int largest = 21;              ///< … up to this one
  /// Whether the receptances are unknowns of their own (NuisanceResiduals), where the structure knows their errors.
  bool receptance_errors = true;
  std::shared_ptr<const FitOfHarmonics> from{};  ///< LawFit::end of a fit of the same unknowns, instead of their values
  FitWork work{};
  minimise::GaussNewtonOptions steps{};
};

/// How a fit ended; what it is worth is the Status of an identification.
enum class LawFitEnd {
  converged,
  not_converged,         ///< Gauss–Newton ended without a minimum: the numbers are those of its last step
  no_response,           ///< harmonic balance has no solution for the law that the fit starts with
  too_few_data,          ///< fewer numbers measured than unknown
  harmonics_not_enough,  ///< a minimum, but the last harmonics that could be added still moved it
  at_kink  ///< one where χ² bends sharply (a loop of one state's motion appears or vanishes): up to a deviation off
};
std::string_view word(LawFitEnd status);
/// Whether the numbers are those of a minimum.
bool is_minimum(LawFitEnd status);

/// One fit with the harmonics of the model up to `largest`.
struct HarmonicsRound {
  int largest = 0;
  Eigen::VectorXd values;  ///< of the unknown parameters
  double chi_square = 0.0;
  double moved = 0.0;  ///< ‖J δθ‖ since the round before: no combination of parameters moved by more of its deviations
};

/// One joint of the estimate. Deviations are those of the bound.
struct FittedJoint {
  Joint joint;
  std::vector<friction::FittedValue> parameters;       ///< the unknown ones
  friction::FittedValue stiffness;                     ///< T′(0) of the friction law
  friction::FittedValue limit;                         ///< its friction limit: extrapolated where no state comes near macroslip
  double smallest_motion = 0.0, largest_motion = 0.0;  ///< |Q₁| over the states, m
};

struct LawFit {
  LawFitEnd status = LawFitEnd::converged;
  std::vector<FittedJoint> joints;
  Eigen::VectorXd values;                 ///< of the unknown parameters, in the order of LawUnknowns
  Eigen::MatrixXd covariance;             ///< of the values, along what the states see
  double chi_square = 0.0;                ///< Σ|X − Y|²/σ², and Σ|δH|²/σ_H² where receptances are unknown, too
  Eigen::Index numbers = 0, freedom = 0;  ///< measured, and priors; less the unknown ones
  double aic = 0.0;                       ///< χ² + 2 · unknowns
  int steps = 0;
  std::vector<StatePrediction> states;
  std::vector<HarmonicsRound> rounds;  ///< one, unless harmonics were added
  std::shared_ptr<const FitOfHarmonics> end;  ///< where another fit can go on
};

std::vector<Joint> joints_of(const LawFit& fit);
/// χ² over its freedom.
double chi_square_of_one(const LawFit& fit);

/// min Σ|Y − X(θ, H)|²/σ² over the unknown parameters, X by harmonic balance, from the values of `unknowns`; where the structure
/// knows errors of H or the states those of P, then over the true H and P as well, + Σ|δH|²/σ_H² + Σ|δP|²/σ_P²
/// (NuisanceResiduals). Throws InputError for states that do not fit the structure, or nothing unknown; want of convergence is a
/// status.
LawFit fit_laws(std::shared_ptr<const Receptance> structure, const std::vector<MeasuredState>& states,
                const LawUnknowns& unknowns, const LawFitOptions& options = {});

/// No fit: what fit_laws would give of states that are exactly those of the values of `unknowns` (status not_converged where they
/// are not). Its deviations are the bound that the states' and the structure's errors allow (response.md §10.2).
LawFit bound_of_laws(std::shared_ptr<const Receptance> structure, const std::vector<MeasuredState>& states, const LawUnknowns& unknowns,
                     const std::vector<int>& harmonics);

}  // namespace jointid::response
