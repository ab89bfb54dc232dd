#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "base/eigen.hpp"

namespace jointid::oscillation {

/// A stick–slip record at a contact: samples of equal number.
struct FrictionRecord {
  std::span<const double> velocity;  ///< V_r, of the drive relative to the body, m/s
  std::span<const double> force;     ///< f on the body, N, with the sign of V_r while it slips
  std::span<const double> normal;    ///< N > 0; empty: `force` is already divided by it
};

struct FrictionRecordOptions {
  double stick_speed = 0.0;  ///< samples with |V_r| ≤ this stick; > 0, above the noise of V_r
  double most_decay = 0.0;   ///< α is searched up to this, s/m; 0: 30 over the median of the slipping speeds
};

/// μ(V) = μ_K + (μ_S − μ_K)e^{−αV} (Kappagantu 3.4) with standard errors, or μ = μ_K if a falling law explains the slipping
/// samples no better (AIC). A stick only bounds μ_S from below: by the largest |f|/N while sticking.
struct FrictionLaw {
  std::size_t stick_samples = 0, slip_samples = 0;
  std::optional<double> static_bound;  ///< μ_S ≥ this; empty without sticking samples
  double kinetic = 0.0, kinetic_error = 0.0;
  bool falls = false;
  double drop = 0.0, drop_error = 0.0;    ///< μ_S − μ_K of the fit, 0 for a constant law
  double decay = 0.0, decay_error = 0.0;  ///< α, s/m
  double scatter = 0.0;                   ///< standard deviation of the residuals of μ
  std::string remark;                     ///< limits of the record; empty if there are none
};

/// Throws InputError for lengths that differ, no slipping sample or N ≤ 0. With samples of one speed only, α is not determined
/// and the law is constant.
FrictionLaw friction_law(const FrictionRecord& record, const FrictionRecordOptions& options);

/// f = e·(Mẍ + Cẋ + Kx): contact force along e of a model at an instant of measured motion.
double contact_force(const Eigen::VectorXd& direction, const Eigen::MatrixXd& mass, const Eigen::MatrixXd& damping,
                     const Eigen::MatrixXd& stiffness, const Eigen::VectorXd& x, const Eigen::VectorXd& v,
                     const Eigen::VectorXd& a);

/// For an undamped tribometer of one mass whose force is a sawtooth between `largest` and `smallest`. μ_K is their mean over N,
/// as a slip carries the spring from μ_S N to (2μ_K − μ_S)N. μ_S is the largest over N.
struct SawtoothFriction {
  double kinetic = 0.0, static_bound = 0.0;
};
SawtoothFriction sawtooth_friction(double largest, double smallest, double normal);

}  // namespace jointid::oscillation
