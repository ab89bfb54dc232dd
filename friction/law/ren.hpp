#pragma once

#include <array>

#include "friction/law/listed_law.hpp"

namespace jointid::friction {

/// Microslip element with u(h) = a e^{bh}: displacement at which the share h of the stiffness has slipped (docs/formulas.md
/// §10a; 2.59, 2.60). T = k∫₀¹ min(u, u(h)) dh; b = 0 is the bilinear element.
class Ren final : public ListedLaw<Ren> {
 public:
  static const Law law;

  /// {a, b, k}: displacement where slip begins (m), spread (–), initial stiffness (N/m).
  explicit Ren(std::span<const double> values);

  Response response(double u) const override;
  double energy(double u) const override;
  double displacement(double force) const override;
  double limit() const override { return limit_; }
  std::vector<double> kinks() const override;
  std::vector<Parameter> parameters() const override { return with_values(law, std::array{begin_, spread_, stiffness_}); }
  void derivative(double u, std::span<double> out) const override;
  double cycle_energy(double u) const override;
  double equivalent_stiffness(double u) const override;
  double second_moment(double u) const override;
  void second_moment_derivative(double u, std::span<double> out) const override;

 private:
  double slipped_share(double u) const;

  double begin_, spread_, stiffness_;
  double end_;    ///< displacement at macroslip, a e^b
  double limit_;  ///< ka(e^b − 1)/b
};

}  // namespace jointid::friction
