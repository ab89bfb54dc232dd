#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "base/complex.hpp"

namespace jointid::impedance {

/// How the smoothing parameter λ of a spline is chosen (18), (19).
enum class Smoothing {
  marginal,  ///< marginal likelihood
  gcv,       ///< generalised cross-validation: needs no scale of the variances
  cp,        ///< Mallows' C_p
  given      ///< λ as given
};

std::string name(Smoothing smoothing);
const std::vector<std::string>& smoothing_names();  ///< those that choose λ

/// Cubic B-splines over equal knots, second differences of their coefficients penalised (17): min Σ|z_q − b_q c|²/C_q + λ|D₂c|².
struct SplineFit {
  double lambda = 0.0, criterion = 0.0;  ///< criterion: NaN where λ was given
  double degrees = 0.0;                  ///< effective ones, e = tr S
  double rss = 0.0, gcv = 0.0, cp = 0.0, marginal = 0.0;
  Eigen::VectorXcd coefficients, z;
  Eigen::VectorXd variance;           ///< E|δ|² by Bayes (20): covers on average over the lines
  Eigen::VectorXd variance_sampling;  ///< (21), without the bias of smoothing
};

/// Of at least four values at ascending frequencies with E|e|² = `variance` > 0; at least four splines.
SplineFit fit_spline(const std::vector<double>& frequency_hz, const Eigen::VectorXcd& z, const Eigen::VectorXd& variance,
                     std::size_t splines, Smoothing smoothing, double lambda = 0.0);

}  // namespace jointid::impedance
