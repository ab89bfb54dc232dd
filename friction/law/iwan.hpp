#pragma once

#include <array>

#include "friction/law/listed_law.hpp"

namespace jointid::friction {

/// Four-parameter Iwan model (Segalman 2005): sliders of density ρ(φ) = Rφ^χ up to φ_max, and S sliders that all slip at φ_max.
/// With r = u/φ_max, φ_max = f(1+β)/(k(β + (χ+1)/(χ+2))): T = ku(1 − r^{χ+1}/((χ+2)(1+β))) up to φ_max, then f. For small
/// amplitudes the energy of a cycle grows as u^{χ+3}.
class Iwan final : public ListedLaw<Iwan> {
 public:
  static const Law law;

  /// {f, k, chi, beta}: limit F_S (N), initial stiffness K_T (N/m), exponent χ > −1, ratio of S to the rest of the stiffness.
  explicit Iwan(std::span<const double> values);

  Response response(double u) const override;
  double energy(double u) const override;
  double limit() const override { return limit_; }
  std::vector<double> kinks() const override { return {slip_}; }
  std::vector<Parameter> parameters() const override {
    return with_values(law, std::array{limit_, stiffness_, exponent_, ratio_});
  }
  void derivative(double u, std::span<double> out) const override;
  double cycle_energy(double u) const override;
  double equivalent_stiffness(double u) const override;
  double second_moment(double u) const override;
  void second_moment_derivative(double u, std::span<double> out) const override;

 private:
  double loss_of_stiffness(double u) const;

  double limit_, stiffness_, exponent_, ratio_;
  double slip_;  ///< φ_max
};

}  // namespace jointid::friction
