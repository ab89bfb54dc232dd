#pragma once

#include <optional>
#include <vector>

#include "base/status.hpp"
#include "impedance/law/law.hpp"
#include "impedance/line/line_value.hpp"

namespace jointid::impedance {

/// Which elements follow laws, and how masses stand beside them: value of element e = Σ_s place(e, s) z_s(ω) − ω² Σ_i mass(e, i)
/// m_i.
struct LawLayout {
  std::vector<std::string> names, units;  ///< of the z_s
  Eigen::MatrixXd place;                  ///< [elements × S]
  Eigen::MatrixXd mass;                   ///< [elements × masses], no columns without
  std::vector<std::string> mass_names, mass_units;
  bool shared = false;  ///< z_s = K_s g(ω), g common: one law of the joint; else every z_s has a law of its own
};

struct FittedParameter {
  std::string name, unit;
  double value = 0.0, std_error = 0.0;
};

/// A law over the lines: min Σ rᵀC⁻¹r, r the real and imaginary parts of line values minus law, C their covariance (22).
struct LawFit {
  LawKind law = LawKind::hysteretic;
  bool converged = false;
  std::vector<FittedParameter> parameters;
  Eigen::VectorXd theta;
  Eigen::MatrixXd covariance;
  double chi_square = 0.0, freedom = 0.0, aic = 0.0;
  std::vector<double> by_line;                  ///< χ²
  std::vector<std::optional<LineValue>> lines;  ///< the law's values of the elements, with their covariance
};

/// The lines that have a value with a finite covariance; `omega` in rad/s.
LawFit fit_law(LawKind law, const LawLayout& layout, const std::vector<double>& omega,
               const std::vector<std::optional<LineValue>>& lines);

/// Laws by AIC, least first; those that did not converge last.
std::vector<LawFit> fit_laws(const std::vector<LawKind>& laws, const LawLayout& layout, const std::vector<double>& omega,
                             const std::vector<std::optional<LineValue>>& lines);

}  // namespace jointid::impedance
