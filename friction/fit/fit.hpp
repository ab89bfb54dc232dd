#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/status.hpp"
#include "friction/curve/curve.hpp"
#include "friction/fit/fit_options.hpp"
#include "friction/fit/fit_start.hpp"
#include "friction/fit/fitted_value.hpp"
#include "friction/path/element.hpp"

namespace jointid::friction {

/// One curve and the element found for it.
struct CurveFit {
  Curve curve;
  std::shared_ptr<const Element> element;
  std::vector<double> predicted;            ///< by row of the curve
  std::vector<FittedValue> parameters;      ///< of the element, in its order
  FittedValue limit;                        ///< T at macroslip
  FittedValue stiffness;                    ///< initial stiffness dT/du(0)
  std::optional<FittedValue> friction_coefficient;  ///< limit over normal load, where that is known
  bool shows_slip = false;                  ///< the element explains the curve better, by AIC, than a linear spring
  double slipped_share = 0.0;               ///< h of (2.53) at the largest displacement; 1: macroslip
  double objective = 0.0;                   ///< ΔE (2.58b), or (7.20)
};

/// Usable results may have findings; others (not_converged, too_few_points) give the reason in `message`.
struct Fit {
  Status status = Status::ok;
  std::string message;
  std::string law, title;
  std::vector<CurveFit> curves;
  double objective = 0.0;      ///< sum of the curves'
  double weighted_sum = 0.0;   ///< what was minimised
  double residual_std = 0.0;   ///< √(weighted_sum/(rows − unknowns)): the noise, as the weighting scales it
  double neighbour_correlation = 0.0;  ///< correlation of neighbouring residuals; near 0 for independent errors
  std::size_t rows = 0, unknowns = 0;
  double aic = 0.0;            ///< rows·ln(weighted_sum/rows) + 2(unknowns + 1); comparable for one set of data and one weighting
  std::vector<std::string> names;                 ///< of the unknowns
  std::vector<std::vector<double>> correlation;   ///< of the unknowns; NaN for undetermined ones
  std::size_t iterations = 0;
  std::string minimiser;       ///< the minimiser used
  std::vector<std::string> findings;  ///< limits of the curves, in words
};

/// Fits the law of `family` to curves by weighted least squares. Unknowns are the parameters on their ParameterScale. Standard
/// errors are those of the linearised problem. The noise is estimated from the residuals, taken as independent; intervals use
/// Student's t. Throws InputError for curves that validate() refuses and options that contradict each other.
Fit fit(std::span<const Curve> curves, const Family& family, const FitOptions& options = {});

/// Fits every family and sorts by AIC, best first; fits that are not usable come last.
std::vector<Fit> compare(std::span<const Curve> curves, std::span<const Family> families, const FitOptions& options = {});

}  // namespace jointid::friction
